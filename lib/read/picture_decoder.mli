(** Picture files that a scene names.

    Files whose numbers are whole, PNG and PPM of 8 or 16 bits, hold sRGB and
    are made linear by its transfer function (IEC 61966-2-1:1999); PFM is linear
    already. Alpha is left aside. The format is told by the contents of a file,
    but its name must end in one of [.png], [.ppm] and [.pfm], in either case.

    Errors are one line, without the name of the file: it has no such ending, is
    not there, may not be read, is not a regular file, holds no such picture, is
    broken, or has more than 65,536 pixels one way. *)

open Candor_scene

val load : string -> (Texels.t, string) result
(** [load path] is the picture in the file [path], linear. A number that is
    negative or not finite is an error too. Never raises. *)

val load_reflectance : string -> (Texels.t, string) result
(** [load_reflectance path] is [load path], with an error for a number above 1,
    which reflects more light than it gets. *)

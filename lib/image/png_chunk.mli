(** The chunks that a PNG file is made of. *)

type t = { kind : string;  (** four letters, such as [IDAT]. *) data : string }

val write : t list -> string
(** [write chunks] is the PNG signature and [chunks], each with its length and
    checksum. *)

val read : string -> (t list, string) result
(** [read file] is the chunks of [file] up to and including [IEND], an error
    when the signature or a checksum is wrong or the file ends early.

    {b Law.} [read (write chunks)] is [Ok chunks] when only the last of [chunks]
    is an [IEND]. *)

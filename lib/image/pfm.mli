(** Portable float maps: linear radiance in single precision. *)

val encode : Picture.t -> string
(** [encode p] is the lines [PF], width and height, [-1.0], and then [p] rounded
    to single precision, little-endian, rows from the bottom to the top. *)

val decode : string -> (Picture.t, string) result
(** [decode file] is the picture in a [PF] (colour) or [Pf] (grey) [file]. Its
    third number is the scale: negative for little-endian data, positive for
    big-endian; samples are multiplied by its absolute value. Infinities and
    [nan]s are kept.

    {b Law.} [decode (encode p)] is [p] rounded to single precision, bit for
    bit. *)

(** Portable pixmaps: plain (P3) and binary (P6). *)

val encode_p3 : Picture.t -> string
(** [encode_p3 p] is [p] as displayed, byte for byte as smallpt writes it: the
    lines [P3], width and height, [255], and then every sample in decimal, each
    with a space behind it, all on one line without an end. *)

val encode_p6 : Picture.t -> string
(** [encode_p6 p] holds the numbers of [encode_p3 p] as bytes. *)

val decode : string -> (Raster.t, string) result
(** [decode file] is the raster that a P3 or P6 [file] holds: with comments, any
    blanks and a largest value in \[1;65535\]; from 256 on, binary samples have
    two bytes, the high one first. What follows the last sample is ignored.

    {b Law.} [decode (encode_p3 p)] and [decode (encode_p6 p)] are
    [Ok (Raster.of_picture p)]. *)

(** Portable network graphics (W3C, {e Portable Network Graphics}, 3rd ed.). *)

val encode : Picture.t -> string
(** [encode p] is [p] as displayed: 8-bit RGB, not interlaced, rows filtered
    adaptively, with a [gAMA] chunk of 1/2.2 that says what
    {!Candor_colour.Display} did. *)

val decode : string -> (Raster.t, string) result
(** [decode file] is the raster that [file] holds: grey, RGB, palette, grey with
    alpha or RGBA, at any depth. Its largest value is 2^depth − 1, for palettes
    255. Alpha, transparent colours and [gAMA] are left aside. An error when a
    checksum is wrong, the data are not as long as the size asks for, or the
    file is interlaced.

    {b Law.} [decode (encode p)] is [Ok (Raster.of_picture p)]. *)

(** The row filters of PNG (W3C, {e Portable Network Graphics}, 3rd ed., 9):
    each byte of a row is stored less its prediction from the bytes around. *)

type t = Plain | Sub | Up | Average | Paeth

val encode : stride:int -> above:Bytes.t -> Bytes.t -> string
(** [encode ~stride ~above row] is [row] as a PNG holds it: the filter's byte,
    then the residues. Of the five filters it takes the one whose residues, read
    as signed bytes, have the smallest sum of absolute values; the first of
    equals. [stride] is the distance in bytes to the pixel on the left, [above]
    the row before, zeros for the first. *)

val decode :
  stride:int -> above:Bytes.t -> Bytes.t -> int -> (Bytes.t, string) result
(** [decode ~stride ~above data at] is the row, as long as [above], whose
    filter's byte is at index [at] of [data]; an error when there is no such
    filter. *)

(** Numbers of things, in words. *)

val count : int -> string -> string
(** [count n noun] is [n] of what one is called [noun], such as ["1 path"] and
    ["2 paths"]. *)

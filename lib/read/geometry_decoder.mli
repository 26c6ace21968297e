(** Points, vectors and lengths. *)

open Candor_space
open Decode

val point : Point.t body
(** [point] is [X Y Z], each at most 2^400 in size. *)

val vector : Vec.t body
(** [vector] is the same of a displacement. *)

val direction : Vec.t body
(** [direction] is a vector that is not zero, as written. *)

val length : string -> float body
(** [length "D"] is a number at most 2^400 in size. *)

val size : string -> float body
(** [size "R"] is a number in \[2^-400;2^400\]. *)

val radii : Vec.t body
(** [radii] is three sizes. *)

val bounds : Bounds.t body
(** [bounds] is the fields [min] and [max]. *)

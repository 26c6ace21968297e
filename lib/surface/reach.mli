(** How far scenes reach: coordinates up to 2^400 either way, so that no square
    on the way to a hit overflows. *)

open Candor_space

val length : float -> bool
(** [length x] is [true] iff |x| ≤ 2^400; [false] for [nan]. *)

val point : Point.t -> bool
(** [point p] is [true] iff every coordinate is within {!length}. *)

val vec : Vec.t -> bool
(** [vec a] is [true] iff every component is within {!length}. *)

val message : string
(** [message] tells a user what was wrong. *)

(** What a light path carries from one surface to the next: one immutable value.
*)

open Candor_colour

type t = {
  throughput : Rgb.t;  (** the share of what is found that reaches the camera *)
  depth : int;  (** reflections so far *)
}

val start : t
(** [start] is the path of a camera ray: throughput 1, depth 0. *)

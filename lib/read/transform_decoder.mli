(** Transforms of groups. *)

open Candor_space
open Decode

val steps : Transform.step list body
(** [steps] is the steps of a transform that can be undone. *)

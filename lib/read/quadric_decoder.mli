(** Quadrics. *)

open Candor_surface
open Fields

val quadric : (Quadric.t, string) result fields
(** [quadric] is one shape with [clip] and [caps]. *)

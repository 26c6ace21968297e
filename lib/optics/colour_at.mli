(** The colour of a texture at a point. *)

open Candor_colour
open Candor_surface
open Candor_scene

val v : Texture.t -> Local.t -> Rgb.t
(** [v texture point] is the colour there, in the surface's own space. *)

(** What surfaces are made of. *)

open Candor_scene
open Decode

val definition : (string * Span.t * Material.t option) body
(** [definition] is [NAME (...)], as in [(material NAME (matte ...))]. *)

val use : Scene.material body
(** [use] is the name of a material, or a material. *)

val anisotropy : float Fields.fields
(** [anisotropy] is Henyey and Greenstein's, in \]-1;1\[; 0 if left out. *)

(** The ways a surface sends light on, at one point of it. *)

open Candor_colour
open Candor_surface
open Candor_scene

type highlight = { specular : Rgb.t; shininess : float }

type t = {
  diffuse : Rgb.t;  (** albedo of the matte part: its BRDF is [diffuse]/π *)
  highlight : highlight option;  (** Blinn's, for lights only *)
  mirror : Rgb.t;  (** how much of a perfect reflection is seen *)
}
(** Black where a material has no such part. *)

val of_material : Material.t -> Local.t -> t
(** [of_material m point] are [m]'s lobes with its colours at [point]. *)

val mirrors : Material.t -> bool
(** [mirrors m] is [true] iff [m] reflects somewhere: its mirror lobe is not
    black everywhere. *)

val diffuses : Material.t -> bool
(** [diffuses m] is [true] iff [m] has a matte part or a highlight that is not
    black everywhere: light falling on it can be seen. *)

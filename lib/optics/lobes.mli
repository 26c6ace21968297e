(** The ways a surface sends light on, at one point of it. *)

open Candor_space
open Candor_colour
open Candor_surface
open Candor_scene

type highlight = { specular : Rgb.t; shininess : float }

type t = {
  diffuse : Rgb.t;  (** albedo of the matte part: its BRDF is [diffuse]/π *)
  highlight : highlight option;  (** Blinn's, for lights only *)
  mirror : Rgb.t;  (** how much of a perfect reflection is seen *)
  gloss : Gloss.t option;
      (** rough reflection, or what is under a smooth coat *)
}
(** Black or [None] where a material has no such part. What goes through a
    surface is not among them. *)

type at = Local.t -> normal:Dir.t -> view:Vec.t -> t
(** The lobes at a point: [normal] is the shading normal on the viewer's side,
    [view] points to the viewer and may be of any length. *)

val compile : Material.t -> at
(** [compile m] are [m]'s lobes with its colours at a point; work that does not
    depend on the point is done once. *)

(** {1 Which materials have them} *)

val mirrors : Material.t -> bool
(** [mirrors m] is [true] iff [m] reflects somewhere like a mirror. *)

val diffuses : Material.t -> bool
(** [diffuses m] is [true] iff [m] has a matte part or a highlight that is not
    black everywhere. *)

val glosses : Material.t -> bool
(** [glosses m] is [true] iff [m] has a [gloss] that is not black everywhere. *)

val responds : Material.t -> bool
(** [responds m] is [true] iff light that falls on [m] from small lights can be
    seen: it {!diffuses} or {!glosses}. *)

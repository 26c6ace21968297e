(** Light of the sky: the bright parts of a background picture shine on
    surfaces. *)

open Candor_space
open Candor_colour
open Candor_scene
open Candor_optics

val name : string
val meaning : string

val calls : Scene.t -> Reason.t list
(** [calls s] is [(indirect-light)], where the background is a picture and light
    that falls on something can be seen. *)

val sky : Scene.t -> Sampled_sky.t option
(** [sky s] is the picture of [s]'s background, if it has one that is not black.
*)

val estimate :
  ?veil:Direct.veil -> Sampled_sky.t -> Tracer.t -> Direct.scattered
(** [estimate sky tracer] is the light of one direction, chosen by how bright it
    is, over the chance of that; shared with paths that go on by themselves, as
    in {!Soft_shadows}. *)

val weigh : Sampled_sky.t -> Path.t -> Vec.t -> float
(** [weigh sky path d] is the share of a path that comes to the sky by itself.
*)

val term :
  Scattering.t -> goes_on:(Term.vertex -> bool) -> Direct.scattered -> Term.t
(** [term scattering ~goes_on estimate] adds the light of the sky to surfaces.
*)

val radiance : Scene.t -> Sampled_sky.t option -> Path.t -> Vec.t -> Rgb.t
(** [radiance s sky] is what a path finds where it meets no surface, in full
    unless a [sky] is asked for its light in both ways. *)

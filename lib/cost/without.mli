(** Scenes that lack something. *)

open Candor_scene
open Candor_effect

type light = { name : string; place : Place.t; dark : Scene.t }
(** A light, where the scene says it, and the scene without it. *)

val lights : Scene.t -> light list
(** [lights s] are the lights of [s] that are not black: those without extent,
    the surfaces that emit (which stay, dark; all parts of a mesh or a polygon,
    and all uses of a definition, together), ambient light and background. *)

val textures : Scene.t -> Scene.t
(** [textures s] has each texture's mean colour in its place: of a picture that
    of its texels, of a checker or noise that of both colours. *)

val smooth_normals : Scene.t -> Scene.t
(** [smooth_normals s] shades triangles as the flat surfaces they are. *)

val absent : Effect.t -> Scene.t -> (Scene.t * (Scene.t -> Plan.t)) option
(** [absent e s] is what to render, and how to plan it, to leave [e] out; [None]
    for anti-aliasing, which is a matter of samples. *)

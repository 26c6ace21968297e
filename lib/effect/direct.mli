(** Direct light: what lights without extent send straight to a surface. *)

open Candor_space
open Candor_scene
open Candor_colour
open Candor_optics

val name : string
val meaning : string

val calls : Scene.t -> Reason.t list
(** [calls s] are the lights of [s] that can be seen: not black, and something
    has a part that shows them. *)

val shines : Light.t -> bool
(** [shines l] is [true] iff [l] is not black. *)

val describe : Light.t -> string
(** [describe l] is what kind of light [l] is, in words. *)

(** {1 How surfaces show it} *)

type shading = {
  is_dark : Lobes.t -> bool;  (** whether light cannot be seen there *)
  outgoing : Lobes.t -> normal:Dir.t -> view:Vec.t -> Illumination.t -> Rgb.t;
      (** the radiance towards [view] under one light alone, nothing in between;
          black if the light is behind *)
}

val matte : shading
(** [matte] shows diffuse/π·E·cosθ, and specular·E·max(0, n·h)^shininess with h
    halfway between the light and the viewer (J. F. Blinn,
    {e Models of Light Reflection for Computer Synthesized Pictures}, 1977), E
    the irradiance on a surface facing the light. *)

val glossy : shading
(** [glossy] shows {!Gloss} as well. *)

(** {1 What is between} *)

type reach = {
  surface : Tally.t -> Path.t -> Tracer.hit -> bool;
      (** whether a light that a surface faces reaches it *)
  space : Tally.t -> Path.t -> Point.t -> bool;
      (** whether it reaches a point between surfaces *)
}

val always : reach
(** [always] is for lights that cast no shadows: no ray is traced. *)

type veil = Path.t -> Point.t -> Illumination.source -> Rgb.t
(** What part of its light comes through the medium that the path is in. *)

type lamp = { light : Light.t; reach : reach }

(** {1 The sum} *)

val term : shading -> ?veil:veil -> lamp list -> Term.t
(** [term shading lamps] adds what each light on the side that the path came
    from adds. *)

type scattered = Tally.t -> Path.t -> Receiver.t -> Rgb.t

val scattered : ?veil:veil -> lamp list -> scattered
(** [scattered lamps] is the light of all that a point of a medium scatters to
    the viewer. *)

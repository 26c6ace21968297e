(** Direct light: what lights without extent send straight to a surface. *)

open Candor_space
open Candor_scene
open Candor_surface
open Candor_optics

val name : string
val meaning : string

val calls : Scene.t -> Reason.t list
(** [calls s] are the lights of [s] that can be seen: not black, and something
    has a matte part or a highlight. *)

type reach = Tally.t -> Assembly.skin Hit.t -> bool
(** Whether a light that a surface faces reaches it. *)

val always : reach
(** [always] is for lights that cast no shadows: no ray is traced. *)

val term : (Light.t * reach) list -> Term.t
(** [term lights] adds, for each light that is on the side the path came from,
    diffuse/π·E·cosθ, and specular·E·max(0, n·h)^shininess with h halfway
    between the light and the viewer (J. F. Blinn,
    {e Models of Light Reflection for Computer Synthesized Pictures}, 1977), E
    the irradiance on a surface facing the light. *)

val outgoing :
  Lobes.t -> normal:Dir.t -> view:Vec.t -> Illumination.t -> Candor_colour.Rgb.t
(** [outgoing lobes ~normal ~view light] is the radiance towards [view] under
    [light] alone, nothing in between; black if the light is behind. *)

(** What happens while light is followed, for those who want to watch. *)

open Candor_space
open Candor_colour
open Candor_surface
open Candor_scene

type cut =
  | Depth  (** the path had as many reflections as it may *)
  | Weight  (** its throughput had fallen below the cut-off *)
[@@deriving show, eq, ord]

type t =
  | Enter of { kind : string; ray : Ray.t; throughput : Rgb.t }
      (** a ray is followed; what happens until its [Leave] belongs to it *)
  | Met of Candor_optics.Skin.t Hit.t
  | Met_nothing
  | Shadow of { light : Light.t; blocked : bool }
      (** a shadow ray was traced *)
  | Toward_emitter of { emitter : Place.t; seen : bool }
      (** a ray was traced towards a surface that emits *)
  | Faces_away of { light : Light.t }
      (** the surface turns its back on the light: no shadow ray *)
  | Cut of cut  (** a reflection was left out *)
  | Term of { name : string; radiance : Rgb.t }
      (** a term of the light equation has this value *)
  | Leave of { radiance : Rgb.t }  (** what the ray brings *)

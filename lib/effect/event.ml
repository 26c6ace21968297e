open Candor_space
open Candor_colour
open Candor_surface
open Candor_scene

type cut = Depth | Weight [@@deriving show, eq, ord]

type t =
  | Enter of { kind : string; ray : Ray.t; throughput : Rgb.t }
  | Met of Candor_optics.Skin.t Hit.t
  | Met_nothing
  | Shadow of { light : Light.t; blocked : bool }
  | Toward_emitter of { emitter : Place.t; seen : bool }
  | Faces_away of { light : Light.t }
  | Cut of cut
  | Term of { name : string; radiance : Rgb.t }
  | Leave of { radiance : Rgb.t }

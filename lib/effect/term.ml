open Candor_space
open Candor_colour
open Candor_surface
open Candor_optics

type vertex = {
  hit : Skin.t Hit.t;
  view : Vec.t;
  lobes : Lobes.t;
  path : Path.t;
}

type radiance = Tally.t -> kind:string -> Path.t -> Ray.t -> Rgb.t
type t = radiance -> Tally.t -> vertex -> Rgb.t

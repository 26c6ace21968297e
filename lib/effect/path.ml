open Candor_colour
open Candor_sample
open Candor_scene
open Candor_optics

type arrival =
  | Sharp
  | Spread of { density : float; from : Area_lights.vantage }

type journey = {
  sample : int;
  time : float;
  arrival : arrival;
  inside : Material.t list;
  wavelength : float option;
}

type t = { throughput : Rgb.t; depth : int; key : Key.t; journey : journey }

let camera key ~sample ~time ~inside =
  let journey = { sample; time; arrival = Sharp; inside; wavelength = None } in
  { throughput = Rgb.white; depth = 0; key; journey }

let start =
  let key = Key.v ~seed:0 ~x:0 ~y:0 ~sample:0 ~bounce:0 Path in
  camera key ~sample:0 ~time:0. ~inside:[]

let one p purpose = Sobol.one ~key:(Key.below p.key purpose) p.journey.sample
let pair p purpose = Sobol.pair ~key:(Key.below p.key purpose) p.journey.sample

let onward p branch throughput journey =
  { throughput; depth = p.depth + 1; key = Key.below p.key branch; journey }

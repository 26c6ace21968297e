open Candor_number
open Candor_colour
open Candor_scene
open Candor_sample
open Candor_optics
open Candor_effect

type t = {
  surface : Assembly.skin Candor_surface.Surface.t;
  plan : Plan.t;
  pattern : Pattern.t;
  spp : int;
  filter : Scene.filter;
  aim : float -> float -> Candor_space.Ray.t;
  light : Tally.t -> Candor_space.Ray.t -> Rgb.t;
}

let compile ?plan ?math (scene : Scene.t) =
  let plan =
    match plan with Some plan -> plan | None -> Plan.of_scene scene
  in
  let surface = Assembly.surface ?math scene in
  let { Scene.spp; seed; filter; _ } = scene.settings in
  {
    surface;
    plan;
    pattern = Pattern.make ~seed ~spp;
    spp;
    filter;
    aim = Aim.compile scene.camera ~width:scene.width ~height:scene.height;
    light = Radiance.compile plan scene surface;
  }

let surface p = p.surface
let plan p = p.plan

(* Where in the pixel, from its top left corner. *)
let spread (filter : Scene.filter) u =
  match filter with Box -> u | Tent -> 0.5 +. Pattern.tent u

let ray p ~x ~y ~sample =
  let { Pattern.u; v } = Pattern.position p.pattern ~x ~y sample in
  let column = float_of_int x +. spread p.filter u
  and row = float_of_int y +. spread p.filter v in
  p.aim column row

let sample p tally ~x ~y ~sample =
  let radiance = p.light tally (ray p ~x ~y ~sample) in
  if not (Rgb.is_finite radiance) then Tally.count tally Non_finite;
  radiance

let radiance p tally ~x ~y =
  let mean s = Running_sum.total s /. float_of_int p.spp in
  let rec sum i r g b =
    if i = p.spp then Rgb.v (mean r) (mean g) (mean b)
    else
      let c = sample p tally ~x ~y ~sample:i in
      Running_sum.(sum (i + 1) (add r c.r) (add g c.g) (add b c.b))
  in
  Running_sum.(sum 0 zero zero zero)

open Candor_number
open Candor_space
open Candor_colour
open Candor_scene
open Candor_sample
open Candor_optics
open Candor_effect

(* Sample [sample] of pixel (x, y), at that column and row. *)
type shoot = Tally.t -> x:int -> y:int -> sample:int -> float -> float -> Rgb.t

type t = {
  surface : Skin.t Candor_surface.Surface.t;
  plan : Plan.t;
  spp : int;
  film : x:int -> y:int -> int -> Pattern.position;
  filter : Scene.filter;
  path : x:int -> y:int -> sample:int -> Path.t;
  aim : Path.t -> float -> float -> Ray.t;
  shoot : shoot;
  decided : Anti_aliasing.decided;
}

(* {1 Paths at the camera} *)

let path plan sampler (scene : Scene.t) =
  let seed = scene.settings.seed in
  let time =
    if Plan.is_on plan Motion_blur then Motion_blur.time scene else fun _ -> 0.
  in
  let at_random ~x ~y ~sample =
    let stream = Sampler.stream sampler sample in
    let sample = Sampler.index sampler sample in
    let key = Key.v ~seed ~x ~y ~sample:stream ~bounce:0 Path in
    let time = time (Sobol.one ~key:(Key.below key Shutter) sample) in
    Path.camera key ~sample ~time ~inside:[]
  in
  if Plan.is_random plan then at_random
  else fun ~x:_ ~y:_ ~sample:_ -> Path.start

let aim plan (scene : Scene.t) =
  let { Scene.camera; width; height; _ } = scene in
  if Plan.is_on plan Depth_of_field then
    let lens = Depth_of_field.lens scene in
    let ray = Aim.compile_lens camera lens ~width ~height in
    fun path x y -> ray x y (Path.pair path Lens)
  else
    let ray = Aim.compile camera ~width ~height in
    fun _ x y -> ray x y

(* Rays that start in one place start in the same bodies. *)
let start_together plan (c : Camera.t) =
  Option.is_none c.near
  && (not (Plan.is_called plan Motion_blur))
  && (not (Plan.is_called plan Depth_of_field))
  &&
  match c.frame with
  | Perspective_angle _ | Perspective_window _ | Panorama -> true
  | Orthographic_height _ | Orthographic_window _ -> false

let inside plan (scene : Scene.t) tracer aim =
  let put (path : Path.t) inside =
    { path with journey = { path.journey with inside } }
  in
  if start_together plan scene.camera then
    let middle n = float_of_int n /. 2. in
    let ray = aim Path.start (middle scene.width) (middle scene.height) in
    match Immersion.v tracer Path.start ray with
    | [] -> fun path _ -> path
    | _ :: _ as inside -> fun path _ -> put path inside
  else fun path ray ->
    match Immersion.v tracer path ray with
    | [] -> path
    | _ :: _ as inside -> put path inside

let is_plain plan =
  not
    (Plan.is_random plan
    || Plan.is_on plan Depth_of_field
    || Plan.is_on plan Refraction)

(* Where nothing asks for more, all paths start alike. *)
let shoot plan (scene : Scene.t) tracer path aim (light : Radiance.t) : shoot =
  if is_plain plan then
    let { Scene.camera; width; height; _ } = scene in
    let ray = Aim.compile camera ~width ~height in
    fun tally ~x:_ ~y:_ ~sample:_ column row ->
      light tally Path.start (ray column row)
  else if not (Plan.is_on plan Refraction) then
    fun tally ~x ~y ~sample column row ->
    let path = path ~x ~y ~sample in
    light tally path (aim path column row)
  else
    let inside = inside plan scene tracer aim in
    fun tally ~x ~y ~sample column row ->
      let path = path ~x ~y ~sample in
      let ray = aim path column row in
      light tally (inside path ray) ray

(* Forced, all samples are taken. *)
let decided plan (scene : Scene.t) surface =
  match Plan.status plan Anti_aliasing with
  | Called _ when not (Plan.is_forced plan) ->
      Anti_aliasing.background scene surface
  | Called _ | Forced | Off -> Anti_aliasing.none

let compile ?plan ?math ?(sampler = Sampler.Sobol) (scene : Scene.t) =
  let plan =
    match plan with Some plan -> plan | None -> Plan.of_scene scene
  in
  let surface = Skin.surface ?math scene in
  let equation = Plan.compile plan scene surface in
  let { Scene.spp; seed; filter; _ } = scene.settings in
  let path = path plan sampler scene and aim = aim plan scene in
  let light = Radiance.compile equation in
  {
    surface;
    plan;
    spp;
    film = Sampler.film sampler ~seed ~spp;
    filter;
    path;
    aim;
    shoot = shoot plan scene equation.tracer path aim light;
    decided = decided plan scene surface;
  }

let surface p = p.surface
let plan p = p.plan

(* Where in the pixel, from its top left corner. *)
let spread (filter : Scene.filter) u =
  match filter with Box -> u | Tent -> 0.5 +. Pattern.tent u

let column p ~x (at : Pattern.position) = float_of_int x +. spread p.filter at.u
let row p ~y (at : Pattern.position) = float_of_int y +. spread p.filter at.v

let ray p ~x ~y ~sample =
  let at = p.film ~x ~y sample in
  p.aim (p.path ~x ~y ~sample) (column p ~x at) (row p ~y at)

let sample p tally ~x ~y ~sample =
  let at = p.film ~x ~y sample in
  let radiance = p.shoot tally ~x ~y ~sample (column p ~x at) (row p ~y at) in
  if not (Rgb.is_finite radiance) then Tally.count tally Non_finite;
  radiance

(* {1 Sums} *)

let slots = 6 * Sampler.streams

let[@inline] gather sums ~at ~sample (c : Rgb.t) =
  let at = at + (6 * (sample mod Sampler.streams)) in
  Running_sum.accumulate sums at c.r;
  Running_sum.accumulate sums (at + 2) c.g;
  Running_sum.accumulate sums (at + 4) c.b

let add_each p tally ~x ~y ~from ~until sums at =
  for i = from to until - 1 do
    gather sums ~at ~sample:i (sample p tally ~x ~y ~sample:i)
  done

(* The sums are of all, so that they have the same bits. *)
let add_one p tally ~x ~y ~from ~until sums at =
  let c = sample p tally ~x ~y ~sample:from in
  for i = from to until - 1 do
    if i > from then Tally.count tally Spared_samples;
    gather sums ~at ~sample:i c
  done

let add p tally ~x ~y ~from ~until sums at =
  if from < until then
    if p.decided ~x ~y then add_one p tally ~x ~y ~from ~until sums at
    else add_each p tally ~x ~y ~from ~until sums at

let stream_sum sums at ~stream ~channel =
  Running_sum.held sums (at + (6 * stream) + (2 * channel))

let mean sums at ~samples =
  let channel k =
    let rec join i sum =
      if i = Sampler.streams then sum
      else
        join (i + 1)
          (Running_sum.join sum (stream_sum sums at ~stream:i ~channel:k))
    in
    Running_sum.total (join 0 Running_sum.zero) /. float_of_int samples
  in
  Rgb.v (channel 0) (channel 1) (channel 2)

let radiance p tally ~x ~y =
  let sums = Float.Array.make slots 0. in
  add p tally ~x ~y ~from:0 ~until:p.spp sums 0;
  mean sums 0 ~samples:p.spp

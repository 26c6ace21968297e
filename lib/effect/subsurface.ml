open Candor_space
open Candor_colour
open Candor_sample
open Candor_scene
open Candor_optics

let name = "subsurface"
let meaning = "light wanders inside translucent bodies"

let inner (m : Material.t) =
  match m.kind with
  | Translucent _ -> Medium.of_material m
  | Matte _ | Phong _ | Mirror _ | Glazed _ | Glass _ | Metal _ | Plastic _
  | Emitter ->
      None

let calls = Reason.materials (fun m -> Option.is_some (inner m))

(* The step after scattering at [point]; the depth of a path counts surfaces.
   Area lights were not asked there, so what it meets counts in full. *)
let onward (path : Path.t) (medium : Medium.t) weight point along =
  let key = Key.below path.key Deflection in
  let next =
    { path with key; journey = { path.journey with arrival = Sharp } }
  in
  let toward = Medium.deflect medium along (Path.pair next Deflection) in
  let throughput = Rgb.mul path.throughput weight in
  ({ next with throughput }, Ray.v point (toward :> Vec.t))

(* {1 The walk} *)

type scatter = Tally.t -> Path.t -> Receiver.t -> Rgb.t

type body = {
  medium : Medium.t;
  tracer : Tracer.t;
  scatter : scatter;
  tally : Tally.t;
  carried : float;  (** what the path carried where the walk began *)
}

let sum (c : Rgb.t) = c.r +. c.g +. c.b

(* Walks that have lost much go on with the chance of what is left. *)
let survival body (path : Path.t) weight =
  let chance = sum (Rgb.mul path.throughput weight) /. body.carried in
  if chance >= 0.5 then 1.
  else if Path.one path Survival < chance then 1. /. chance
  else 0.

(* What the lights in the body send along the path from [point]. *)
let lit { medium; scatter; tally; _ } path point along =
  scatter tally path
    (Receiver.in_medium medium ~goes_on:false path point ~along)

(* [kept] is what the walk has kept so far, [found] the light of lights on its
   way. A ray that meets nothing has left through a gap. *)
let rec walk body ~found ~kept (path : Path.t) (ray : Ray.t) hit
    (arrive : Segment.arrive) =
  let arrived weight =
    let light = Segment.weighted weight path ray hit arrive in
    Rgb.add found (Rgb.mul kept light)
  in
  if Option.is_none hit then arrived Rgb.white
  else
    let limit = Segment.length ray hit in
    match
      Medium.sample body.medium ~carried:path.throughput ~limit
        (Path.one path Distance)
    with
    | Passed { weight } -> arrived weight
    | Scattered { distance; weight } ->
        let along = Dir.of_vec_or Dir.z ray.direction in
        let point = Point.along ray.origin (along :> Vec.t) distance in
        let kept = Rgb.mul kept weight in
        let light = Rgb.mul kept (lit body path point along) in
        let found = Rgb.add found light
        and survival = survival body path weight in
        if survival = 0. then found
        else (
          Tally.count body.tally Scattered_rays;
          let path, ray =
            onward path body.medium (Rgb.scale survival weight) point along
          in
          let hit = body.tracer.nearest body.tally path ray in
          walk body ~found ~kept:(Rgb.scale survival kept) path ray hit arrive)

let segment tracer scatter : Segment.t =
 fun _ tally path ray hit arrive ->
  match Option.bind (List.nth_opt path.journey.inside 0) inner with
  | None -> arrive path ray hit
  | Some medium when Rgb.is_black medium.scattering ->
      let share = Medium.transmittance medium (Segment.length ray hit) in
      Segment.weighted share path ray hit arrive
  | Some medium ->
      let carried = sum path.throughput in
      let body = { medium; tracer; scatter; tally; carried } in
      walk body ~found:Rgb.black ~kept:Rgb.white path ray hit arrive

(* {1 Lights in bodies} *)

let stands_in tracer at =
  let around = Immersion.v tracer Path.start (Ray.v at (Dir.x :> Vec.t)) in
  List.exists (fun m -> Option.is_some (inner m)) around

let may_reach ~moving tracer (light : Light.t) =
  match light.kind with
  | Directional _ -> false
  | Point { at; _ } | Spot { at; _ } ->
      moving || (not light.shadows) || stands_in tracer at

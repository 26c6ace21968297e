open Candor_space
open Candor_scene
open Candor_surface
open Candor_optics

let name = "shadows"
let meaning = "surfaces between a light and a point take its light away"

let calls (scene : Scene.t) =
  let lit = Direct.calls scene in
  let casts (r : Reason.t) =
    List.exists
      (fun (l : Light.t) -> l.shadows && Place.equal l.place r.place)
      scene.lights
  in
  List.filter casts lit

(* What a light at t = 1 stands on is not in its way: that is met at 1, within
   the error of any t. *)
let before_light = 1. -. 0x1p-50

(* From where [spawn] starts rays, at [point]. *)
let shadow_ray (source : Illumination.source) point spawn =
  match source with
  | Along toward -> spawn toward
  | At light -> Ray.toward light (spawn (Point.sub light point))

let limit : Illumination.source -> float = function
  | Along _ -> infinity
  | At _ -> before_light

let reach (tracer : Tracer.t) (light : Light.t) : Direct.reach =
  let source = Illumination.source light in
  let limit = limit source in
  let is_free tally path ray =
    Tally.count tally Shadow_rays;
    let blocked = tracer.blocked tally path ~limit ray in
    if Tally.watched tally then Tally.show tally (Shadow { light; blocked });
    not blocked
  in
  {
    surface =
      (fun tally path hit ->
        is_free tally path (shadow_ray source hit.point (Hit.spawn_lit hit)));
    space =
      (fun tally path point ->
        is_free tally path (shadow_ray source point (Ray.v point)));
  }

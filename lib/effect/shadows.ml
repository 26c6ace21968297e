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

let shadow_ray source hit =
  match (source : Illumination.source) with
  | Along toward -> (Hit.spawn hit toward, infinity)
  | At light ->
      let ray = Hit.spawn hit (Point.sub light hit.point) in
      (Ray.toward light ray, before_light)

let reach surface (light : Light.t) : Direct.reach =
  let source = Illumination.source light in
  fun tally hit ->
    let ray, limit = shadow_ray source hit in
    Tally.count tally Shadow_rays;
    let effort = Tally.effort tally in
    let blocked = Surface.blocked surface ~effort ~limit ray in
    if Tally.watched tally then Tally.show tally (Shadow { light; blocked });
    not blocked

open Candor_space
open Candor_colour
open Candor_scene
open Candor_surface
open Candor_optics
open Candor_effect

let vertex (hit : Assembly.skin Hit.t) (ray : Ray.t) path : Term.vertex =
  {
    hit;
    view = Vec.neg ray.direction;
    lobes = Lobes.of_material hit.material.material hit.local;
    path;
  }

let watched_term e term : Term.t =
 fun radiance tally vertex ->
  let value = term radiance tally vertex in
  if Tally.watched tally then
    Tally.show tally (Term { name = Effect.name e; radiance = value });
  value

let compile plan (scene : Scene.t) surface =
  let sky = Sky.compile scene.background in
  let terms =
    Plan.compile plan scene surface
    |> List.map (fun (e, term) -> watched_term e term)
    |> Array.of_list
  in
  let rec follow tally path (ray : Ray.t) =
    match Surface.nearest surface ~effort:(Tally.effort tally) ray with
    | None ->
        if Tally.watched tally then Tally.show tally Met_nothing;
        sky ray.direction
    | Some hit ->
        if Tally.watched tally then Tally.show tally (Met hit);
        let vertex = vertex hit ray path in
        Array.fold_left
          (fun sum term -> Rgb.add sum (term radiance tally vertex))
          Rgb.black terms
  and radiance tally ~kind (path : Path.t) ray =
    if not (Tally.watched tally) then follow tally path ray
    else (
      Tally.show tally (Enter { kind; ray; throughput = path.throughput });
      let radiance = follow tally path ray in
      Tally.show tally (Leave { radiance });
      radiance)
  in
  fun tally ray ->
    Tally.count tally Camera_rays;
    radiance tally ~kind:"camera" Path.start ray

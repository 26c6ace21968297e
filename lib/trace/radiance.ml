open Candor_space
open Candor_colour
open Candor_surface
open Candor_optics
open Candor_effect

let vertex (hit : Skin.t Hit.t) (ray : Ray.t) path : Term.vertex =
  let view = Vec.neg ray.direction in
  let lobes = hit.material.lobes hit.local ~normal:hit.shading_normal ~view in
  { hit; view; lobes; path }

let watched_term e term : Term.t =
 fun radiance tally vertex ->
  let value = term radiance tally vertex in
  if Tally.watched tally then
    Tally.show tally (Term { name = Effect.name e; radiance = value });
  value

type t = Tally.t -> Path.t -> Ray.t -> Rgb.t

(* What is found at the end of a ray, in the sky or on a surface; [radiance] is
   what other rays bring. *)
let arrive terms (sky : Path.t -> Vec.t -> Rgb.t) (radiance : Term.radiance)
    tally path (ray : Ray.t) = function
  | None ->
      if Tally.watched tally then Tally.show tally Met_nothing;
      sky path ray.direction
  | Some hit ->
      if Tally.watched tally then Tally.show tally (Met hit);
      let vertex = vertex hit ray path in
      Array.fold_left
        (fun sum (term : Term.t) -> Rgb.add sum (term radiance tally vertex))
        Rgb.black terms

(* Shows where a ray begins and what it brings. *)
let watched follow tally kind (path : Path.t) ray =
  Tally.show tally (Enter { kind; ray; throughput = path.throughput });
  let radiance = follow tally path ray in
  Tally.show tally (Leave { radiance });
  radiance

let compile (equation : Plan.equation) : t =
  let { Plan.sky; tracer = { nearest; _ }; segment; _ } = equation in
  let terms =
    Array.of_list (List.map (fun (e, t) -> watched_term e t) equation.terms)
  in
  let radiance : Term.radiance =
    match segment with
    | None ->
        let rec radiance tally ~kind path ray =
          if Tally.watched tally then watched follow tally kind path ray
          else follow tally path ray
        and follow tally path ray =
          arrive terms sky radiance tally path ray (nearest tally path ray)
        in
        radiance
    | Some through ->
        let rec radiance tally ~kind path ray =
          if Tally.watched tally then watched follow tally kind path ray
          else follow tally path ray
        and follow tally path ray =
          let hit = nearest tally path ray in
          through radiance tally path ray hit (arrive terms sky radiance tally)
        in
        radiance
  in
  fun tally path ray ->
    Tally.count tally Camera_rays;
    radiance tally ~kind:"camera" path ray

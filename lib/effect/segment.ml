open Candor_space
open Candor_colour
open Candor_optics

type arrive = Path.t -> Ray.t -> Tracer.hit option -> Rgb.t

type t =
  Term.radiance ->
  Tally.t ->
  Path.t ->
  Ray.t ->
  Tracer.hit option ->
  arrive ->
  Rgb.t

let length (ray : Ray.t) = function
  | None -> infinity
  | Some (hit : Tracer.hit) -> hit.t *. Vec.norm ray.direction

let weighted weight (path : Path.t) ray hit arrive =
  let throughput = Rgb.mul path.throughput weight in
  Rgb.mul weight (arrive { path with throughput } ray hit)

let distance point (source : Illumination.source) =
  match source with
  | At light -> Vec.norm (Point.sub light point)
  | Along _ -> infinity

let after (first : t) (next : t) : t =
 fun radiance tally path ray hit arrive ->
  first radiance tally path ray hit (fun path ray hit ->
      next radiance tally path ray hit arrive)

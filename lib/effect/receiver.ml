open Candor_space
open Candor_colour
open Candor_surface
open Candor_optics

type t = {
  vantage : Area_lights.vantage;
  spawn : Vec.t -> Ray.t;
  respond : Dir.t -> Rgb.t;
  density : Dir.t -> float;
}

let nowhere (_ : Dir.t) = 0.

let vantage ({ hit; path; _ } : Term.vertex) : Area_lights.vantage =
  let { Hit.path = place; part; side; _ } = hit in
  let departure = Ray.Surface { path = place; part; side } in
  { from = Hit.lit_point hit; departure; time = path.journey.time }

let in_space (path : Path.t) point : Area_lights.vantage =
  { from = point; departure = Nowhere; time = path.journey.time }

let of_vertex (s : Scattering.t) ~goes_on
    ({ hit; view; lobes; _ } as vertex : Term.vertex) =
  let normal = hit.shading_normal in
  let view = Dir.of_vec_or normal view in
  let respond (toward : Dir.t) =
    if Hit.faces hit (toward :> Vec.t) then s.value lobes ~normal ~view ~toward
    else Rgb.black
  in
  let density toward = s.density lobes ~normal ~view ~toward in
  {
    vantage = vantage vertex;
    spawn = Hit.spawn_lit hit;
    respond;
    density = (if goes_on then density else nowhere);
  }

let lit (scattering : Scattering.t) ~goes_on estimate : Term.t =
 fun _ tally vertex ->
  if scattering.is_black vertex.lobes then Rgb.black
  else
    let goes_on = goes_on vertex in
    estimate tally vertex.path (of_vertex scattering ~goes_on vertex)

let in_medium (m : Medium.t) ~goes_on (path : Path.t) point ~along =
  let density = Medium.phase m along in
  {
    vantage = in_space path point;
    spawn = Ray.v point;
    respond = (fun toward -> Rgb.grey (density toward));
    density = (if goes_on then density else nowhere);
  }

(* By the ratio of the two, so that no square overflows. *)
let power p q =
  if p = 0. then 0.
  else
    let r = q /. p in
    1. /. (1. +. (r *. r))

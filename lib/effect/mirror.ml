open Candor_space
open Candor_colour
open Candor_sample
open Candor_surface
open Candor_optics

let name = "mirror"
let meaning = "surfaces reflect what is in front of them"
let calls = Reason.materials Lobes.mirrors

let reflect (n : Dir.t) v =
  let n = (n :> Vec.t) in
  Vec.sub (Vec.scale (2. *. Vec.dot n v) n) v

(* An interpolated normal may send a reflection into the surface; the true
   normal never does. *)
let direction (hit : _ Hit.t) view =
  let r = reflect hit.shading_normal view in
  if Vec.dot (hit.normal :> Vec.t) r > 0. then r else reflect hit.normal view

let sharp (journey : Path.journey) =
  match journey.arrival with
  | Sharp -> journey
  | Spread _ -> { journey with arrival = Sharp }

(* What goes on beside a reflection: what a coat leaves to its base, if it is
   not a matte surface. *)
let beside (lobes : Lobes.t) =
  match lobes.gloss with
  | None -> lobes.diffuse
  | Some _ -> Rgb.grey (1. -. Float.min 1. (Rgb.largest lobes.mirror))

let term limit : Term.t =
 fun radiance tally { hit; view; lobes; path } ->
  if Rgb.is_black lobes.mirror then Rgb.black
  else
    let survival =
      Limit.survival limit tally path Key.Reflected ~weight:lobes.mirror
        ~beside:(beside lobes)
    in
    if survival = 0. then Rgb.black
    else (
      Tally.count tally Mirror_rays;
      let weight = Rgb.scale survival lobes.mirror in
      let path =
        Path.onward path Key.Reflected
          (Rgb.mul path.throughput weight)
          (sharp path.journey)
      in
      let ray = Hit.spawn hit (direction hit view) in
      Rgb.mul weight (radiance tally ~kind:name path ray))

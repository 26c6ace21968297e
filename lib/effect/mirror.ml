open Candor_space
open Candor_colour
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

let cut tally counter event =
  Tally.count tally counter;
  if Tally.watched tally then Tally.show tally (Cut event);
  Rgb.black

let term ~depth ~cutoff : Term.t =
 fun radiance tally { hit; view; lobes; path } ->
  if Rgb.is_black lobes.mirror then Rgb.black
  else
    let throughput = Rgb.mul path.throughput lobes.mirror in
    if path.depth >= depth then cut tally Cut_by_depth Depth
    else if Rgb.largest throughput < cutoff then cut tally Cut_by_weight Weight
    else (
      Tally.count tally Mirror_rays;
      let ray = Hit.spawn hit (direction hit view) in
      let path = { Path.throughput; depth = path.depth + 1 } in
      Rgb.mul lobes.mirror (radiance tally ~kind:name path ray))

open Candor_colour
open Candor_effect
open Candor_trace
open Candor_image
open Candor_render

type t = {
  picture : Picture.t;
  linear : floatarray;
  shown : floatarray;
  times : floatarray;
  seconds : float;
  rays_per_pixel : float;
}

(* What is filled while pixels are rendered, each by one domain. *)
type sheet = { pixel : Pixel.t; linear : floatarray; times : floatarray }

let sheet count pixel =
  {
    pixel;
    linear = Float.Array.make (3 * count) 0.;
    times = Float.Array.make count 0.;
  }

let render subset sheet tally i =
  let x, y = Subset.pixel subset i in
  let clock = Clock.start () in
  let c = Pixel.radiance sheet.pixel tally ~x ~y in
  Float.Array.set sheet.times i (Clock.seconds clock);
  Float.Array.set sheet.linear (3 * i) c.r;
  Float.Array.set sheet.linear ((3 * i) + 1) c.g;
  Float.Array.set sheet.linear ((3 * i) + 2) c.b

(* Pixels [first] and on, up to [next]; the tally if [stop] let them all pass. *)
let stretch ~stop subset sheet ~first ~next =
  let tally = Tally.make () in
  let rec go i =
    if i = next then Some tally
    else if stop () then None
    else (
      render subset sheet tally i;
      go (i + 1))
  in
  go first

(* Pixels' own times leave out what is done once, and processor time what other
   programs do in between. *)
let work ~domains ~processor times =
  let at_once = Int.min domains (Rows.most_domains ()) in
  Float.min
    (Float.Array.fold_left ( +. ) 0. times /. float_of_int domains)
    (processor /. float_of_int at_once)

let finished ~seconds subset sheet tally =
  let at i = Float.Array.get sheet.linear i in
  let width = Subset.width subset in
  let color x y =
    let i = 3 * ((y * width) + x) in
    Rgb.v (at i) (at (i + 1)) (at (i + 2))
  in
  {
    picture = Picture.init ~width ~height:(Subset.height subset) color;
    linear = Float.Array.map (fun x -> 255. *. x) sheet.linear;
    shown = Float.Array.map Display.encode sheet.linear;
    times = sheet.times;
    seconds = seconds /. Subset.share subset;
    rays_per_pixel =
      float_of_int (Tally.total_rays tally)
      /. float_of_int (Subset.count subset);
  }

(* Short enough to share the pixels out evenly. *)
let length ~domains count = Int.max 1 (Int.min 32 (count / (8 * domains)))

let run ~domains ~stop subset pixel =
  let count = Subset.count subset in
  let sheet = sheet count pixel and length = length ~domains count in
  let part k =
    let first = k * length in
    stretch ~stop subset sheet ~first ~next:(Int.min count (first + length))
  in
  let before = Sys.time () in
  let parts =
    Rows.parallel ~domains ~stop ((count + length - 1) / length) part
  in
  let processor = Sys.time () -. before in
  let tallies = List.filter_map Option.join (Array.to_list parts) in
  if List.length tallies < Array.length parts then None
  else
    let seconds = work ~domains ~processor sheet.times in
    Some (finished ~seconds subset sheet (Tally.sum tallies))

(** Measurements made up, and lists of small scenes. *)

open Candor_colour
open Candor_image
open Candor_cost

(** [measure ~seconds values] is pixels whose displayed values are [values]. *)
let measure ?(seconds = 1.) values : Measure.t =
  let count = Array.length values / 3 in
  let level x y =
    let at c = (values.((3 * (x + y)) + c) /. 255.) ** 2.2 in
    Rgb.v (at 0) (at 1) (at 2)
  in
  {
    picture = Picture.init ~width:count ~height:1 level;
    shown = Float.Array.of_list (Array.to_list values);
    times = Float.Array.make count (seconds /. float_of_int count);
    seconds;
    rays_per_pixel = 2.;
  }

let pair ?seconds first second : Pair.t =
  { first = measure ?seconds first; second = measure ?seconds second }

let random = Random.State.make [| 11 |]

let normal () =
  let u = 1. -. Random.State.float random 1. in
  sqrt (-2. *. log u) *. cos (Random.State.float random (2. *. Float.pi))

(** [noisy deviation truth] is [truth] with that much noise. *)
let noisy deviation truth =
  Array.map (fun x -> x +. (deviation *. normal ())) truth

let noisy_pair ?seconds deviation truth =
  pair ?seconds (noisy deviation truth) (noisy deviation truth)

let domains = 1

(** [survey ~seconds scene] is what can be measured in that time. *)
let survey ?(seconds = 0.6) ?(stop = fun () -> false) scene =
  let budget = Budget.start seconds in
  Survey.run { scene; domains; budget; stop; progress = ignore }

(** [prices ~seconds scene] is its price list. *)
let prices ?(seconds = 0.6) scene =
  let budget = Budget.start seconds in
  match
    Survey.run
      { scene; domains; budget; stop = (fun () -> false); progress = ignore }
  with
  | None -> Alcotest.fail "nothing was measured"
  | Some survey ->
      Appraisal.v scene ~file:"made.scene" ~domains budget survey

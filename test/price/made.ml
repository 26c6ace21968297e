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
    linear =
      Float.Array.of_list
        (List.map
           (fun v -> 255. *. ((v /. 255.) ** 2.2))
           (Array.to_list values));
    shown = Float.Array.of_list (Array.to_list values);
    times = Float.Array.make count (seconds /. float_of_int count);
    seconds;
    rays_per_pixel = 2.;
  }

let pair ?seconds first second : Pair.t =
  { first = measure ?seconds first; second = measure ?seconds second }

let normal random =
  let u = 1. -. Random.State.float random 1. in
  sqrt (-2. *. log u) *. cos (Random.State.float random (2. *. Float.pi))

(** [noisy random deviation truth] is [truth] with that much noise. *)
let noisy random deviation truth =
  Array.map (fun x -> x +. (deviation *. normal random)) truth

let noisy_pair random deviation truth =
  let first = noisy random deviation truth in
  pair first (noisy random deviation truth)

let domains = 1

(** [survey ~seconds scene] is what can be measured in that time. *)
let survey ?(seconds = 0.4) ?(stop = fun () -> false) scene =
  let budget = Budget.start seconds in
  Survey.run { scene; domains; budget; stop; progress = ignore }

(** [prices ~seconds scene] is its price list, made in that time, or as much
    more as this machine needs to get through all settings. *)
let rec prices ?(seconds = 0.3) scene =
  let budget = Budget.start seconds in
  let stop () = false in
  match Survey.run { scene; domains; budget; stop; progress = ignore } with
  | None -> Alcotest.fail "nothing was measured"
  | Some { missing = _ :: _; _ } when seconds < 20. ->
      prices ~seconds:(2. *. seconds) scene
  | Some survey -> Appraisal.v scene ~file:"made.scene" ~domains budget survey

(** [hurried scene] is the list made in no time. *)
let hurried scene =
  let budget = Budget.start 1e-6 in
  let stop () = false in
  match Survey.run { scene; domains; budget; stop; progress = ignore } with
  | None -> Alcotest.fail "nothing was measured"
  | Some survey -> Appraisal.v scene ~file:"made.scene" ~domains budget survey

(** [verdict scene wanted] is what is said of the setting of [scene] that
    [wanted] chooses, from all pixels with all of the scene's samples: no clock
    has a say in it, and it saves no time. *)
let verdict (scene : Candor_scene.Scene.t) wanted =
  let { Candor_scene.Scene.width; height; settings = { spp; seed; _ }; _ } =
    scene
  in
  let subset = Subset.make ~width ~height ~seed ~pixels:(width * height) in
  let measured variant seeding =
    let pixel = Variant.compile variant ~spp seeding in
    Option.get (Measure.run ~domains ~stop:(fun () -> false) subset pixel)
  in
  let both variant =
    {
      Pair.first = measured variant Variant.First;
      second = measured variant Second;
    }
  in
  let chosen v = wanted (Variant.setting v) in
  match List.find_opt chosen (Variant.others scene) with
  | None -> Alcotest.fail "there is no such setting"
  | Some variant ->
      let base = both (Variant.own scene spp) in
      (Verdict.v (Variant.setting variant) ~law:None ~finest:base ~base
         (both variant) ~share:1. ~saved:0.)
        .verdict

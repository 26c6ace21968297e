(** What pictures show, with how far chance may have moved it.

    Cameras look at one place through a window so narrow that all pixels see the
    same: the pixels' means are independent estimates of one radiance. *)

open Candor_colour
open Candor_sample
open Candor_effect
open Candor_trace
open Candor_scene_made

type t = { mean : Rgb.t; error : Rgb.t }
(** Means over pixels, and their standard errors. *)

(** [look ~from at] sees the point [at] from the point [from], as coordinates.
*)
let look ?(up = "0 1 0") ~from at =
  Printf.sprintf
    "(camera (perspective (eye %s) (look-at %s) (up %s) (fov-y 1e-7)))" from at
    up

let indirect = "(indirect-light)"

(** [settings ~spp n] is n × n pixels of so many samples each. *)
let settings ?(spp = 16) ?(more = "") n =
  Written.size n n ^ Printf.sprintf "(render (spp %d) %s)" spp more

let map3 f (a : Rgb.t) (b : Rgb.t) = Rgb.v (f a.r b.r) (f a.g b.g) (f a.b b.b)

let of_values values =
  let n = float_of_int (List.length values) in
  let total = List.fold_left Rgb.add Rgb.black in
  let mean = Rgb.scale (1. /. n) (total values) in
  let square = map3 (fun m x -> (x -. m) ** 2.) mean in
  let sum = total (List.map square values) in
  let error = map3 (fun _ s -> sqrt s /. n) sum sum in
  { mean; error }

(** [v forms] is what the picture of these forms shows. *)
let v forms =
  let scene = Written.scene forms in
  let pixel = Pixel.compile scene and tally = Tally.make () in
  List.init (scene.width * scene.height) (fun i ->
      let x = i mod scene.width and y = i / scene.width in
      Pixel.radiance pixel tally ~x ~y)
  |> of_values

(** [changed change forms] is what the picture of these forms shows if the terms
    of its light equation are changed first. *)
let changed change forms =
  let scene = Written.scene forms in
  let plan = Plan.of_scene scene in
  let equation = Plan.compile plan scene (Candor_optics.Skin.surface scene) in
  let terms = List.filter_map change equation.terms in
  let light = Radiance.compile { equation with terms } in
  let { Candor_scene.Scene.width; height; settings; camera; _ } = scene in
  let aim = Candor_optics.Aim.compile camera ~width ~height in
  let tally = Tally.make () in
  let sample x y sample =
    let key = Key.v ~seed:settings.seed ~x ~y ~sample:0 ~bounce:0 Path in
    let path = Path.camera key ~sample ~time:0. ~inside:[] in
    light tally path (aim (float_of_int x +. 0.5) (float_of_int y +. 0.5))
  in
  List.init (width * height) (fun i ->
      let sample = sample (i mod width) (i / width) in
      let sum =
        List.fold_left Rgb.add Rgb.black (List.init settings.spp sample)
      in
      Rgb.scale (1. /. float_of_int settings.spp) sum)
  |> of_values

(** A change: lights are found by the paths that surfaces send out alone. *)
let by_material : Effect.t * Term.t -> (Effect.t * Term.t) option = function
  | Soft_shadows, _ -> None
  | Emission, _ -> Some (Emission, Emission.term ())
  | other -> Some other

let parts (c : Rgb.t) = [ c.r; c.g; c.b ]

let check name ~within ~expected ~value ~error =
  let off = Float.abs (value -. expected) in
  if not (error <= within *. Float.abs expected) then
    Alcotest.failf "%s: the error of %g ± %g says little about %g" name value
      error expected;
  if not (off <= (5. *. error) +. (1e-6 *. Float.abs expected)) then
    Alcotest.failf "%s: %.9g ± %g, not %.9g (z = %.1f)" name value error
      expected (off /. error)

(** [is name expected m] fails if [m] is more than 5 standard errors from
    [expected] (beside one part in 10^6), or if the standard error is more than
    [within] (default 0.01) of it. *)
let is ?(within = 0.01) name expected m =
  List.iter2
    (fun expected (value, error) -> check name ~within ~expected ~value ~error)
    (parts expected)
    (List.combine (parts m.mean) (parts m.error))

(** [agree name a b] fails if the two differ by more than 5 standard errors, or
    if that is more than [within] of them. *)
let agree ?(within = 0.01) name a b =
  let error = map3 Float.hypot a.error b.error in
  is ~within name b.mean { mean = a.mean; error }

(** [exactly name expected m] fails unless every pixel shows [expected], within
    so many parts of it. *)
let exactly ?(within = 1e-12) name expected m =
  let near e (value, error) =
    Float.abs (value -. e) <= within *. e && error <= within *. e
  in
  if
    not
      (List.for_all2 near (parts expected)
         (List.combine (parts m.mean) (parts m.error)))
  then
    Alcotest.failf "%s: %s ± %s, not %s" name (Rgb.show m.mean)
      (Rgb.show m.error) (Rgb.show expected)

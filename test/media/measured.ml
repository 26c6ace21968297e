(** What pictures show, with its standard error, beside what they should. *)

open Candor_number
open Candor_colour
open Candor_scene
open Candor_scene_made
open Candor_image

(** Looks along −z from z = 5, at so little around the origin that every pixel
    has the same in expectation. *)
let needle = "(camera (orthographic (eye 0 0 5) (look-at 0 0 0) (height 1e-6)))"

let scene ?(spp = 16) ?(pixels = 64) forms =
  let render = Printf.sprintf "(render (spp %d))" spp in
  Written.scene (Written.size pixels 1 :: render :: forms)

type t = { mean : float; error : float }

let of_list values =
  let v = List.fold_left Running_variance.add Running_variance.empty values in
  match (Running_variance.mean v, Running_variance.variance v) with
  | Some mean, Some variance ->
      let n = float_of_int (List.length values) in
      { mean; error = sqrt (variance /. n) }
  | None, _ | _, None -> Alcotest.fail "too few values"

let pixels (s : Scene.t) =
  let picture = Shot.picture s in
  List.init (s.width * s.height) (fun i ->
      Picture.pixel picture (i mod s.width) (i / s.width))

type three = { red : t; green : t; blue : t }

(** [v s] are the means over the pixels of [s], which draw lots of their own. *)
let v s =
  let pixels = pixels s in
  let of_ f = of_list (List.map f pixels) in
  {
    red = of_ (fun (c : Rgb.t) -> c.r);
    green = of_ (fun (c : Rgb.t) -> c.g);
    blue = of_ (fun (c : Rgb.t) -> c.b);
  }

let is what { mean; error } expected =
  let rounding = 1e-9 *. Float.abs expected in
  if not (Float.abs (mean -. expected) <= (5. *. error) +. rounding) then
    Alcotest.failf "%s: expected %.6g, got %.6g ± %.2g" what expected mean error

(** [are what measured r g b] is that the means are these. *)
let are what { red; green; blue } r g b =
  is (what ^ ", red") red r;
  is (what ^ ", green") green g;
  is (what ^ ", blue") blue b

(** [agree what a b] is that two measurements are of the same. *)
let agree what a b =
  let one what a b =
    is what { a with error = Float.hypot a.error b.error } b.mean
  in
  one (what ^ ", red") a.red b.red;
  one (what ^ ", green") a.green b.green;
  one (what ^ ", blue") a.blue b.blue

(** [sharp what m] is that the noise of [m] is below the share [most] of it: a
    test of something that drowns in noise shows nothing. *)
let sharp ?(most = 0.05) what { red; green; blue } =
  List.iter
    (fun { mean; error } ->
      if not (error <= most *. mean) then
        Alcotest.failf "%s: %.6g ± %.2g is too noisy" what mean error)
    [ red; green; blue ]

(** [integral f a b] is Simpson's, over 4000 pieces. *)
let integral f a b =
  let n = 4000 in
  let h = (b -. a) /. float_of_int n in
  let weight i =
    if i = 0 || i = n then 1. else if i land 1 = 1 then 4. else 2.
  in
  let term i = weight i *. f (a +. (h *. float_of_int i)) in
  List.fold_left ( +. ) 0. (List.init (n + 1) term) *. h /. 3.

(** [same what a b] is that two scenes look alike to the last bit. *)
let same what a b =
  match Shot.difference (Shot.picture a) (Shot.picture b) with
  | None -> ()
  | Some where -> Alcotest.failf "%s: %s" what where

let not_black what s =
  if List.for_all Rgb.is_black (pixels s) then Alcotest.failf "%s is black" what

(** [alike what a b] is that two scenes look alike but for rounding. *)
let alike what a b =
  let near a b = Float.abs (a -. b) <= 1e-11 *. Float.max a b in
  List.iter2
    (fun (p : Rgb.t) (q : Rgb.t) ->
      if not (near p.r q.r && near p.g q.g && near p.b q.b) then
        Alcotest.failf "%s: %s and %s" what (Rgb.show p) (Rgb.show q))
    (pixels a) (pixels b)

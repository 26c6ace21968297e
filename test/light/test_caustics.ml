(* Light that comes to a floor through glass and from mirrors. *)

open Candor_colour
open Candor_oracle

let floor =
  "(quadric (plane (normal 0 1 0) (offset 0)) (material (matte (color 1))))"

(* A plane mirror doubles a light: π (r/d)² cos of its image. *)
let mirrored () =
  let image (x, y, z) r =
    let square = (x *. x) +. (y *. y) +. (z *. z) in
    r *. r /. square *. (y /. sqrt square)
  in
  let shown =
    Measure.v
      [
        Measure.look ~from:"0 2 6" "0 0 0";
        Measure.settings ~spp:64 32;
        Measure.indirect;
        floor;
        "(box (min -1 -1e4 -1e4) (max -1 1e4 1e4) (material (mirror (color \
         .5))))";
        "(sphere (center 1 1.5 0) (radius .5) (material (emitter (radiance \
         1))))";
      ]
  in
  Measure.is ~within:0.02 "beside a mirror"
    (Rgb.grey (image (1., 1.5, 0.) 0.5 +. (0.5 *. image (-3., 1.5, 0.) 0.5)))
    shown

(* Under a wide slab of glass a wide light shines as through the slab: the mean
   over directions, by cosine, of what it lets through. *)
let under_slab () =
  let through angle =
    let r = Test_glass.reflectance 1. 1.5 angle in
    Test_glass.pile [ r; r ]
  in
  let steps = 20_000 in
  let mean =
    List.init steps (fun i ->
        let square = (float_of_int i +. 0.5) /. float_of_int steps in
        through (asin (sqrt square)))
    |> List.fold_left ( +. ) 0.
  in
  let expected = mean /. float_of_int steps in
  (* The floor is black to what the slab sends back: it is seen by one bounce,
     from below the slab. *)
  let shown =
    Measure.v
      [
        Measure.look ~from:"0 .5 3" "0 0 0";
        Measure.settings ~spp:32 32;
        Measure.indirect;
        "(background 1)";
        "(box (min -1e5 -1 -1e5) (max 1e5 -1 1e5) (material (emitter (radiance \
         0))))";
        "(box (min -1e-3 0 -1e-3) (max 1e-3 0 1e-3) (material (matte (color \
         1))))";
        "(box (min -1e5 1 -1e5) (max 1e5 2 1e5) (material (glass (index 1.5))))";
      ]
  in
  Measure.is ~within:0.01 "under a slab" (Rgb.grey expected) shown

(* {1 Under a ball of glass}

   A point, a ball of glass and a ball of light stand on the y axis: what the
   point sees along a direction stays in a plane, where rays are pairs. *)

let dot (a, b) (c, d) = (a *. c) +. (b *. d)
let along (x, y) k (a, b) = (x +. (k *. a), y +. (k *. b))

(* Where a ray enters a circle, if it meets it. *)
let circle center radius o d =
  let f = along center (-1.) o in
  let b = dot f d in
  let discriminant = (b *. b) -. dot f f +. (radius *. radius) in
  if discriminant < 0. then None else Some (b -. sqrt discriminant)

let index = 1.5
let glass = ((0., 1.5), 1.)
let light = ((0., 5.), 1.)

let bend n d ~from ~into =
  let r = from /. into in
  let cos = -.dot n d in
  let k = 1. -. (r *. r *. (1. -. (cos *. cos))) in
  along (r *. fst d, r *. snd d) ((r *. cos) -. sqrt k) n

(* The light that comes to the origin along an angle from the axis, by so many
   reflections inside the ball at most. *)
let seen angle =
  let center, radius = glass in
  let d = (sin angle, cos angle) in
  match circle center radius (0., 0.) d with
  | None -> 0.
  | Some t ->
      let p = along (0., 0.) t d in
      let n = along center (-1.) p in
      let n = (-.fst n, -.snd n) in
      let r =
        Test_glass.reflectance 1. index (acos (Float.min 1. (-.dot n d)))
      in
      let rec inside k share p d =
        if k > 8 then 0.
        else
          let t = -2. *. dot (along p (-1.) center) d in
          let q = along p t d in
          let n = along center (-1.) q in
          let out = bend n d ~from:index ~into:1. in
          let shines =
            match circle (fst light) (snd light) q out with
            | Some t when t > 0. -> share *. (1. -. r)
            | Some _ | None -> 0.
          in
          let back = along d (-2. *. dot n d) n in
          shines +. inside (k + 1) (share *. r) q back
      in
      inside 0 (1. -. r) p (bend n d ~from:1. ~into:index)

let under_ball () =
  let steps = 40_000 in
  let width = Float.pi /. 2. /. float_of_int steps in
  let part i =
    let a = (float_of_int i +. 0.5) *. width in
    2. *. sin a *. cos a *. seen a *. width
  in
  let expected =
    List.fold_left (fun s i -> s +. part i) 0. (List.init steps Fun.id)
  in
  Measure.is ~within:0.015 "under a ball" (Rgb.grey expected)
    (Measure.v
       [
         Measure.look ~from:"0 .2 1" "0 0 0";
         Measure.settings ~spp:32 24;
         Measure.indirect;
         "(box (min -1e-3 0 -1e-3) (max 1e-3 0 1e-3) (material (matte (color \
          1))))";
         "(sphere (center 0 1.5 0) (radius 1) (material (glass (index 1.5))))";
         "(sphere (center 0 5 0) (radius 1) (material (emitter (radiance 1))))";
       ])

let suite =
  ( "caustics",
    [
      Law.example "a mirror doubles a light" mirrored;
      Law.example "a sky shines through a slab" under_slab;
      Law.example "a ball of glass gathers light" under_ball;
    ] )

(* Pictures of translucent bodies. *)

open Candor_oracle
open Candor_colour
open Candor_scene_made

let needle = Measured.needle
let indirect = "(indirect-light)"
let white = "(background 1)"

let translucent ?(index = 1.) ?(g = 0.) ~scattering absorption =
  Printf.sprintf
    "(material (translucent (index %g) (scattering %s) (absorption %s) \
     (anisotropy %g)))"
    index scattering absorption g

let ball material =
  Printf.sprintf "(sphere (center 0 0 0) (radius 1) %s)" material

(* {1 Nothing is lost} *)

let furnace ?(more = []) ~index ~g scattering () =
  let body = ball (translucent ~index ~g ~scattering "0") in
  let s =
    Measured.scene ~pixels:128 ~spp:64 ([ needle; white; indirect; body ] @ more)
  in
  let m = Measured.v s in
  Measured.sharp "the furnace" m;
  Measured.are "the furnace" m 1. 1. 1.

let colours = "(rgb .5 1 3)"
let chalk = "(sphere (center 0 0 0) (radius .5) (material (matte (color 1))))"

let marble =
  "(sphere (center 0 0 0) (radius .5) (material (glass (index 1.7))))"

(* {1 What is absorbed} *)

let sky = "(background (gradient (down (rgb 1 0 .5)) (up (rgb 0 2 .5))))"

let like_glass () =
  List.iter
    (fun more ->
      let seen material =
        Measured.scene ~pixels:16 ~spp:4
          ([ Written.flat_camera; sky; ball material ] @ more)
      in
      let glass = "(material (glass (index 1.4) (absorption (rgb 0 .3 2))))" in
      let cloudless = translucent ~index:1.4 ~scattering:"0" "(rgb 0 .3 2)" in
      Measured.not_black "glass" (seen glass);
      Measured.same "a body that only absorbs" (seen glass) (seen cloudless))
    [ []; [ indirect ] ]

let almost_clear () =
  let seen material =
    Measured.v
      (Measured.scene ~pixels:16 ~spp:16
         [
           "(camera (orthographic (eye .3 .4 5) (look-at .3 .4 0) (height \
            1e-6)))";
           sky;
           indirect;
           ball material;
         ])
  in
  let thin = Printf.sprintf "(rgb %g %g %g)" 0x1p-60 0x1p-60 0x1p-60 in
  Measured.agree "next to nothing"
    (seen "(material (glass (index 1)))")
    (seen (translucent ~scattering:thin thin))

(* Of a thick body that scatters evenly, S. Chandrasekhar, Radiative Transfer,
   1950: under even light from all around it sends back 1 - H(cos) sqrt(1 - w),
   where H(x) = 1 / (sqrt(1 - w) + w/2 integral of y H(y) / (x + y)). *)
let half_space w =
  let n = 200 in
  let at i = (float_of_int i +. 0.5) /. float_of_int n in
  let next h =
    Array.init n (fun i ->
        let part j hj = at j *. hj /. (at i +. at j) /. float_of_int n in
        let sum = Array.fold_left ( +. ) 0. (Array.mapi part h) in
        1. /. (sqrt (1. -. w) +. (w /. 2. *. sum)))
  in
  let rec iterate k h = if k = 0 then h else iterate (k - 1) (next h) in
  let h = iterate 60 (Array.make n 1.) in
  let last = ((3. *. h.(n - 1)) -. h.(n - 2)) /. 2. in
  1. -. (last *. sqrt (1. -. w))

let thick () =
  let body =
    ball (translucent ~scattering:"(rgb 180 100 40)" "(rgb 20 100 160)")
  in
  let m =
    Measured.v
      (Measured.scene ~pixels:128 ~spp:32 [ needle; white; indirect; body ])
  in
  Measured.sharp "a thick body" m;
  Measured.are "a thick body" m (half_space 0.9) (half_space 0.5)
    (half_space 0.2)

(* {1 Long ways} *)

let finite what s =
  if not (List.for_all Rgb.is_finite (Measured.pixels s)) then
    Alcotest.failf "%s is not finite" what

let long_walk () =
  let body = ball (translucent ~index:1.3 ~scattering:"400" "0") in
  let s = Measured.scene ~pixels:8 ~spp:4 [ needle; white; indirect; body ] in
  finite "milk" s

let gap () =
  let face = "(triangle (-1 -1 0) (1 -1 0) (0 1 0))" in
  let open_body =
    Printf.sprintf "(group %s %s)" (translucent ~scattering:"9" "0") face
  in
  let s =
    Measured.scene ~pixels:8 ~spp:4 [ needle; white; indirect; open_body ]
  in
  finite "a body with a gap" s

(* {1 Lights inside} *)

(* A lamp of constant irradiance 1 lights all of a ball that absorbs nothing:
   what it sends out in all directions together, over 4π, is what one view of it
   adds up to. Light that was not scattered is not seen. *)
let lamp = "(light (point (at 0 0 0) (intensity (rgb 1 2 3)) (falloff none)))"

let lit_from_inside k irradiance =
  let q = (1. /. k) +. (2. /. (k *. k)) +. (2. /. (k *. k *. k)) in
  irradiance *. k *. ((2. /. (k *. k *. k)) -. (exp (-.k) *. q))

let totals s =
  let one seed =
    let s = Written.with_settings (fun x -> { x with seed }) s in
    let sum f =
      let pixels = Measured.pixels s in
      List.fold_left (fun sum c -> sum +. f c) 0. pixels
      *. 4.
      /. float_of_int (List.length pixels)
    in
    (sum (fun (c : Rgb.t) -> c.r), sum (fun c -> c.g), sum (fun c -> c.b))
  in
  let all = List.init 12 one in
  {
    Measured.red = Measured.of_list (List.map (fun (r, _, _) -> r) all);
    green = Measured.of_list (List.map (fun (_, g, _) -> g) all);
    blue = Measured.of_list (List.map (fun (_, _, b) -> b) all);
  }

let of_a_lamp ~indirect ~g () =
  let s =
    Written.scene
      ([
         Written.size 16 16;
         "(render (spp 16))";
         Written.flat_camera;
         ball (translucent ~g ~scattering:colours "0");
         lamp;
       ]
      @ if indirect then [ "(indirect-light)" ] else [])
  in
  let m = totals s in
  Measured.sharp "a lamp in milk" m;
  Measured.are "a lamp in milk" m (lit_from_inside 0.5 1.)
    (lit_from_inside 1. 2.) (lit_from_inside 3. 3.)

(* Light of a lamp outside does not come in, but by refraction as a lamp has
   none. *)
let lamp_outside () =
  let s =
    Measured.scene
      [
        needle;
        ball (translucent ~scattering:colours "0");
        "(light (point (at 0 0 3) (intensity 5)))";
      ]
  in
  Alcotest.(check bool)
    "black" true
    (List.for_all Rgb.is_black (Measured.pixels s))

(* In milk, a hollow bulb that shines inwards, too, the camera in it and a white
   ball: whatever the ball sees, and the milk between, is as bright. *)
let bulb () =
  let oven =
    "(sphere (center 0 0 0) (radius 9) (both-sides) (material (emitter \
     (radiance 1))))"
  and milk =
    Printf.sprintf "(sphere (center 0 0 0) (radius 12) %s)"
      (translucent ~scattering:"(rgb .2 .3 .4)" "0")
  in
  let camera = "(camera (perspective (eye 0 0 3) (look-at 0 0 0) (fov-y 1)))" in
  let s =
    Measured.scene ~pixels:128 ~spp:1024 [ camera; indirect; milk; oven; chalk ]
  in
  let m = Measured.v s in
  Measured.sharp ~most:0.005 "the oven" m;
  Measured.are "the oven" m 1. 1. 1.

let suite =
  ( "bodies",
    [
      Law.example "a ball loses nothing" (furnace ~index:1. ~g:0. colours);
      Law.example "scattering forwards" (furnace ~index:1. ~g:0.8 colours);
      Law.example "under a skin" (furnace ~index:1.5 ~g:0. colours);
      Law.example "under a skin, backwards"
        (furnace ~index:1.5 ~g:(-0.6) colours);
      Law.example "with a matte ball inside"
        (furnace ~more:[ chalk ] ~index:1.5 ~g:0.3 colours);
      Law.example "with a glass ball inside"
        (furnace ~more:[ marble ] ~index:1.2 ~g:0.3 colours);
      Law.example "one that only absorbs is glass to the bit" like_glass;
      Law.example "one of next to nothing is not there" almost_clear;
      Law.example "a thick one sends back what theory says" thick;
      Law.example "walks may be long" long_walk;
      Law.example "a body with a gap ends" gap;
      Law.example "a lamp inside, all its light comes out"
        (of_a_lamp ~indirect:true ~g:0.);
      Law.example "the same without indirect light"
        (of_a_lamp ~indirect:false ~g:0.5);
      Law.example "a lamp outside stays there" lamp_outside;
      Law.example "area lights inside are met" bulb;
    ] )

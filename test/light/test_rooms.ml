(* Closed rooms: what paths of many steps add up to. *)

open Candor_colour
open Candor_oracle

let albedo = Rgb.v 0.5 0.75 0.25
let glow = Rgb.v 1. 0.5 2.

(* The camera is inside, and every surface emits from both sides. *)
let room ?(n = 24) ?(spp = 16) ?(more = "") shape material =
  [
    Measure.look ~from:".2 .1 .3" "1 .7 .4";
    Measure.settings ~spp ~more n;
    Measure.indirect;
    Printf.sprintf "(%s (material %s) (both-sides))" shape material;
  ]

let box = "box (min -1 -1 -1) (max 1 1 1)"
let ball = "sphere (center 0 0 0) (radius 1.5)"
let matte = "(matte (color (rgb .5 .75 .25)) (emission (rgb 1 .5 2)))"
let series albedo glow = Measure.map3 (fun a e -> e /. (1. -. a)) albedo glow

let balance () =
  let check name shape material albedo =
    Measure.is ~within:0.015 name (series albedo glow)
      (Measure.v (room ~n:28 shape material))
  in
  check "a matte box" box matte albedo;
  check "a matte ball" ball matte albedo;
  check "a glazed box" box
    "(glazed (color (rgb .25 .5 .125)) (mirror (rgb .25 .25 .125)) (emission \
     (rgb 1 .5 2)))"
    albedo

(* Mirrors everywhere but on a ball of the same colours. *)
let mirrors () =
  let walls = "(mirror (color (rgb .5 .75 .25)) (emission (rgb 1 .5 2)))" in
  Measure.is "a box of mirrors" (series albedo glow)
    (Measure.v
       (room box walls
       @ [
           Printf.sprintf "(sphere (center .3 -.4 0) (radius .3) (material %s))"
             matte;
         ]))

let by_paths_alone () =
  Measure.is "without light sampling" (series albedo glow)
    (Measure.changed Measure.by_material (room box matte))

(* e (1 + a + a² + … + a^depth): light sampling counts as a step that it
   saves. *)
let truncated () =
  let sum depth =
    Measure.map3
      (fun a e -> e *. (1. -. (a ** float_of_int (depth + 1))) /. (1. -. a))
      albedo glow
  in
  List.iter
    (fun depth ->
      let more = Printf.sprintf "(depth %d)" depth in
      Measure.is
        (Printf.sprintf "%d bounces, with light sampling" depth)
        (sum (depth + 1))
        (Measure.v (room ~more box matte));
      Measure.is
        (Printf.sprintf "%d bounces, by paths alone" depth)
        (sum depth)
        (Measure.changed Measure.by_material (room ~more box matte)))
    [ 0; 1; 2; 3 ]

(* With a few things in it, of materials that lose nothing. *)
let furnished () =
  let things =
    [
      "(sphere (center .5 .5 -.5) (radius .4) (material (glass (index 1.5))))";
      "(sphere (center -.5 -.5 .5) (radius .4) (material (mirror)))";
      "(box (min -.9 -.9 -.9) (max -.4 0 -.3) (material (matte (color (rgb .5 \
       .75 .25)) (emission (rgb 1 .5 2)))))";
    ]
  in
  Measure.is "a room with things in it" (series albedo glow)
    (Measure.v (room box matte @ things))

(* {1 Roulette} *)

let gallery =
  [
    Measure.look ~from:"0 0 .9" ".3 .2 -1";
    Measure.indirect;
    "(box (min -1 -1 -1) (max 1 1 1) (material (matte (color (rgb .8 .6 .4)))))";
    "(sphere (center .3 .6 0) (radius .2) (material (emitter (radiance 3))))";
    "(sphere (center -.4 -.6 -.2) (radius .35) (material (glass (index 1.5) \
     (color .9))))";
    "(sphere (center .5 -.6 .2) (radius .3) (material (glazed (color .4) \
     (mirror .5))))";
    "(sphere (center -.5 .4 -.4) (radius .3) (material (plastic (color .7) \
     (index 1.5) (roughness 0))))";
    "(sphere (center .6 .3 -.6) (radius .3) (material (metal (reflectance .8) \
     (roughness .3))))";
  ]

let without_roulette scene (e, term) =
  let fixed = Candor_effect.Limit.Fixed { depth = 14; cutoff = 0. } in
  let term : Candor_effect.Term.t =
    match (e : Candor_effect.Effect.t) with
    | Indirect ->
        Candor_effect.Indirect.term Candor_optics.Scattering.glossy fixed
    | Mirror -> Candor_effect.Mirror.term fixed
    | Refraction ->
        Candor_effect.Refraction.term Candor_effect.Refraction.index ~splits:1
          fixed
          (Candor_effect.Tracer.still (Candor_optics.Skin.surface scene))
    | _ -> term
  in
  Some (e, term)

let unbiased () =
  let scene n spp = Measure.settings ~spp n :: gallery in
  Measure.agree ~within:0.04 "with roulette and without"
    (Measure.v (scene 40 16))
    (Measure.changed
       (without_roulette (Candor_scene_made.Written.scene (scene 12 8)))
       (scene 12 8))

(* {1 Images of images} *)

(* Two mirrors of colour .8 face each other across the z axis, at z = ±1, with a
   matte wall between them under a point light without shadows: every image of
   the light is one more light, at z = 2k + (-1)^k z0, of colour .8^|k|. *)
let facing_mirrors () =
  let z0 = 0.25 in
  let mirror z =
    Printf.sprintf
      "(box (min -1e4 -1e4 %g) (max 1e4 1e4 %g) (material (mirror (color .8))))"
      z z
  in
  (* The ray goes to the mirror at z = -1, and by turns to both; after k
     reflections it is at the image k of the ball, if the ball is that. *)
  let ball =
    Printf.sprintf
      "(sphere (center 0 0 %g) (radius .1) (material (emitter (radiance 1))))"
      z0
  in
  let view image =
    let sign = if image land 1 = 0 then 1. else -1. in
    let at = (-2. *. float_of_int image) +. (sign *. z0) in
    Measure.v
      [
        Measure.look ~from:"0 5 .5" (Printf.sprintf "0 0 %.17g" at);
        Measure.settings ~spp:1 ~more:"(depth 40)" 1;
        mirror 1.;
        mirror (-1.);
        ball;
      ]
  in
  List.iter
    (fun image ->
      Measure.exactly
        (Printf.sprintf "image %d" image)
        (Rgb.grey (0.8 ** float_of_int image))
        (view image))
    [ 0; 1; 2; 3; 4; 7; 12 ]

(* A floor between two mirrors at x = ±1, lit by a ball in their middle: its
   images that the depth allows shine like balls, π L (r/d)² cos each. *)
let mirror_hall () =
  let mirror x =
    Printf.sprintf
      "(box (min %g -1e4 -1e4) (max %g 1e4 1e4) (material (mirror (color \
       .75))))"
      x x
  in
  let radius = 0.3 and height = 1.5 in
  let image k =
    let aside = 2. *. float_of_int k in
    let square = (aside *. aside) +. (height *. height) in
    (0.75 ** float_of_int (abs k))
    *. (radius *. radius /. square)
    *. (height /. sqrt square)
  in
  let shines =
    List.fold_left (fun s k -> s +. image k) 0. [ -2; -1; 0; 1; 2 ]
  in
  Measure.is ~within:0.02 "between mirrors" (Rgb.grey shines)
    (Measure.v
       [
         Measure.look ~from:"0 2 6" "0 0 0";
         Measure.settings ~spp:64 ~more:"(depth 3)" 40;
         Measure.indirect;
         mirror 1.;
         mirror (-1.);
         "(quadric (plane (normal 0 1 0) (offset 0)) (material (matte (color \
          1))))";
         Printf.sprintf
           "(sphere (center 0 %g 0) (radius %g) (material (emitter (radiance \
            1))))"
           height radius;
       ])

let suite =
  ( "rooms",
    [
      Law.example "a closed room has radiance e/(1 - a)" balance;
      Law.example "so has a room of mirrors" mirrors;
      Law.example "by its paths alone, too" by_paths_alone;
      Law.example "and so many bounces of it under a depth" truncated;
      Law.example "glass and mirrors in it change nothing" furnished;
      Law.example "roulette changes no mean" unbiased;
      Law.example "facing mirrors show image behind image" facing_mirrors;
      Law.example "images of a light shine like lights" mirror_hall;
    ] )

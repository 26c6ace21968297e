(* Pictures in fog. *)

open Candor_oracle
open Candor_colour
open Candor_scene_made

let needle = Measured.needle

let wall =
  "(box (min -10 -10 -1) (max 10 10 0) (material (emitter (radiance (rgb 1 2 \
   3)))))"

let floor = "(box (min -10 -10 -1) (max 10 10 0) (material (matte (color .7))))"

let fog ?(albedo = "0") ?(g = 0.) ?within extinction =
  Printf.sprintf "(fog (extinction %s) (albedo %s) (anisotropy %g)%s)"
    extinction albedo g
    (match within with
    | None -> ""
    | Some (low, high) -> Printf.sprintf "(within (min %s) (max %s))" low high)

let colours = "(rgb .1 .5 1)"
let many = "(rgb .5 1 2)"
let indirect = "(indirect-light)"
let lamp = "(light (point (at 1 0 1) (intensity (rgb 3 2 1))))"

let sun ?(toward = "0 0 -1") () =
  Printf.sprintf "(light (directional (direction %s) (irradiance (rgb 1 2 3))))"
    toward

(* {1 What comes through} *)

let weakened forms length =
  let s = Measured.scene ~spp:2 ~pixels:4 ([ needle; wall ] @ forms) in
  let near what expected x =
    if not (Float.abs (x -. expected) <= 1e-13 *. expected) then
      Alcotest.failf "%s: expected %h, got %h" what expected x
  in
  let through rate = exp (-.rate *. length) in
  let check (c : Rgb.t) =
    near "red" (through 0.1) c.r;
    near "green" (2. *. through 0.5) c.g;
    near "blue" (3. *. through 1.) c.b
  in
  List.iter check (Measured.pixels s)

let transmittance () =
  weakened [ fog colours ] 5.;
  weakened [ fog colours ~within:("-20 -20 1", "20 20 3") ] 2.;
  weakened [ fog colours ~within:("-20 -20 -7", "20 20 3") ] 3.;
  weakened [ fog colours ~within:("1 -20 -7", "20 20 3") ] 0.;
  weakened [ fog colours; indirect ] 5.

let clear () =
  List.iter
    (fun more ->
      let seen fog =
        Measured.scene ~pixels:8 ([ needle; floor; lamp ] @ more @ fog)
      in
      Measured.same "clear fog" (seen []) (seen [ fog "0" ~albedo:".5" ]))
    [ []; [ indirect ] ]

let shown_everywhere more =
  Measured.scene ~pixels:16 ~spp:4
    ([ Written.flat_camera; floor; wall; lamp; fog many ~albedo:".6" ~g:0.4 ]
    @ more)

let scaled () =
  List.iter
    (fun more ->
      let s = shown_everywhere more in
      Measured.not_black "the fog" s;
      List.iter
        (fun k -> Measured.same "another scale" s (Scaled.by k s))
        [ 0x1p-40; 0x1p13 ])
    [ []; [ indirect; "(background 0)" ] ]

(* {1 What is scattered once} *)

(* By light that falls in along the ray's own direction, and at an angle. *)
let henyey_greenstein g cos =
  (1. -. (g *. g))
  /. (4. *. Float.pi *. ((1. +. (g *. g) -. (2. *. g *. cos)) ** 1.5))

let once = [ []; [ indirect; "(render (depth 0))" ] ]

let seen_once what forms (red, green, blue) =
  List.iter
    (fun more ->
      let render = if more = [] then [] else [ List.hd more ] in
      let s = Measured.scene ~spp:64 ([ needle ] @ forms @ render) in
      let depth (x : Candor_scene.Scene.settings) =
        { x with depth = (if more = [] then x.depth else Some 0) }
      in
      let m = Measured.v (Written.with_settings depth s) in
      Measured.sharp what m;
      Measured.are what m red green blue)
    once

let slab = ("-1000 -1000 0", "1000 1000 2")

let from_a_sun ~g ~toward ~cos ~slant () =
  let one rate albedo irradiance =
    let rate' = rate *. (1. +. slant) in
    albedo *. rate *. irradiance *. henyey_greenstein g cos
    *. (1. -. exp (-2. *. rate'))
    /. rate'
  in
  seen_once "a slab under a sun"
    [ fog many ~albedo:"(rgb .9 .5 .2)" ~g ~within:slab; sun ~toward () ]
    (one 0.5 0.9 1., one 1. 0.5 2., one 2. 0.2 3.)

let from_behind = from_a_sun ~g:0.3 ~toward:"0 0 -1" ~cos:(-1.) ~slant:1.
let aslant = from_a_sun ~g:(-0.6) ~toward:"3 0 -4" ~cos:(-0.8) ~slant:1.25

(* The lamp is at (1, 0, 1), the ray along the third axis from 5. *)
let from_a_lamp () =
  let g = 0.4 in
  let one rate intensity =
    Measured.integral
      (fun s ->
        let z = 5. -. s in
        let square = 1. +. ((1. -. z) *. (1. -. z)) in
        let r = sqrt square in
        0.8 *. rate *. intensity
        *. henyey_greenstein g ((z -. 1.) /. r)
        *. exp (-.rate *. (s +. r))
        /. square)
      0. 60.
  in
  seen_once "fog around a lamp"
    [ fog many ~albedo:".8" ~g; lamp ]
    (one 0.5 3., one 1. 2., one 2. 1.)

(* The sun comes from the side; a box keeps it from what is below z = 1. *)
let shaded = ("-1 -1 0", "1 1 2")
let shade = "(box (min -5 -5 -5) (max -4 5 1) (material (matte (color 0))))"

let shadows () =
  let one rate irradiance =
    rate *. irradiance *. henyey_greenstein 0. 0. *. exp (-.rate)
    *. (1. -. exp (-.rate))
    /. rate
  in
  seen_once "half in shadow"
    [ fog many ~albedo:"1" ~within:shaded; shade; sun ~toward:"1 0 0" () ]
    (one 0.5 1., one 1. 2., one 2. 3.)

let all_in_shadow () =
  let roof = "(box (min -9 -9 6) (max 9 9 7))" in
  let s =
    Measured.scene [ needle; roof; fog many ~albedo:"1" ~within:shaded; sun () ]
  in
  Alcotest.(check bool)
    "black" true
    (List.for_all Rgb.is_black (Measured.pixels s))

(* {1 Again and again} *)

let white = "(background 1)"

let furnace g extinction () =
  let fog = fog extinction ~albedo:"1" ~g ~within:("-1 -1 -1", "1 1 1") in
  let m =
    Measured.v (Measured.scene ~spp:256 [ needle; white; indirect; fog ])
  in
  Measured.sharp "the furnace" m;
  Measured.are "the furnace" m 1. 1. 1.

(* A ball that shines inwards, all around. *)
let oven =
  "(sphere (center 0 0 0) (radius 9) (both-sides) (material (emitter (radiance \
   1))))"

let area_light ~floor g () =
  let fog = fog many ~albedo:"1" ~g ~within:("-1 -1 -1", "1 1 1") in
  let ball =
    if floor then
      [ "(sphere (center 0 0 -.5) (radius .4) (material (matte (color 1))))" ]
    else []
  in
  let m =
    Measured.v
      (Measured.scene ~spp:512 ([ needle; oven; indirect; fog ] @ ball))
  in
  Measured.sharp "the oven" m;
  Measured.are "the oven" m 1. 1. 1.

(* At depth 0 lights are asked and nothing else: as without indirect light. *)
let light_only () =
  let seen more =
    let fog = fog many ~albedo:".9" ~g:0.6 ~within:("-1 -1 -1", "1 1 1") in
    let s = Measured.scene ~spp:512 ([ needle; oven; fog ] @ more) in
    Measured.v (Written.with_settings (fun s -> { s with depth = Some 0 }) s)
  in
  let a = seen [] and b = seen [ indirect ] in
  Measured.sharp ~most:0.01 "once" a;
  Measured.sharp ~most:0.01 "once" b;
  Measured.agree "an area light in fog" a b

let suite =
  ( "fog",
    [
      Law.example "a wall behind it is weakened by the law" transmittance;
      Law.example "clear fog leaves the bits" clear;
      Law.example "a power of two leaves the bits" scaled;
      Law.example "it scatters the light of a sun behind the camera" from_behind;
      Law.example "it scatters the light of a sun aslant" aslant;
      Law.example "it scatters the light of a lamp" from_a_lamp;
      Law.example "surfaces throw their shadows through it" shadows;
      Law.example "in full shadow it is black" all_in_shadow;
      Law.example "a furnace, scattering evenly" (furnace 0. "2");
      Law.example "a furnace, scattering forwards" (furnace 0.8 many);
      Law.example "a furnace, scattering backwards" (furnace (-0.7) many);
      Law.example "a furnace heated by an area light"
        (area_light ~floor:false 0.5);
      Law.example "a white ball in that" (area_light ~floor:true (-0.3));
      Law.example "area lights are asked alike with bounces and without"
        light_only;
    ] )

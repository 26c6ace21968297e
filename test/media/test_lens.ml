(* Pictures through a lens. *)

open Candor_oracle
open Candor_colour
open Candor_effect
open Candor_scene_made
open Candor_image

let camera ?lens ?(near = "") ?(fov = 20.) () =
  let lens =
    match lens with
    | None -> ""
    | Some (radius, focus) ->
        Printf.sprintf "(aperture-radius %g) (focus-distance %g)" radius focus
  in
  Printf.sprintf
    "(camera (perspective (eye 0 0 0) (look-at 0 0 -1) (fov-y %g) %s %s))" fov
    lens near

let room =
  [
    "(background (gradient (down .2) (up (rgb .4 .6 1))))";
    "(light (point (at 3 4 0) (intensity 40)))";
    "(sphere (center .3 .1 -5) (radius .6) (material (glazed (color .5) \
     (mirror .3))))";
    "(quadric (plane (normal 0 1 0) (offset -1)) (material (matte (color \
     (checker .2 .8)))))";
  ]

let view camera =
  Written.scene (Written.size 12 8 :: "(render (spp 4))" :: camera :: room)

let pinhole () =
  List.iter
    (fun near ->
      Measured.same "a lens of one point"
        (view (camera ~near ()))
        (view (camera ~near ~lens:(0., 3.) ())))
    [ ""; "(near 4.8)" ]

let forced () =
  let s = view (camera ()) in
  Alcotest.check Shot.bits "all effects" (Shot.picture s)
    (Shot.picture ~plan:(Plan.all s) s)

let scaled () =
  let s = view (camera ~lens:(0.1, 3.) ~near:"(near .5)" ()) in
  Measured.same "another scale" s (Scaled.by 0x1p-30 s)

(* {1 Sharp where it is focused} *)

let board =
  "(box (min -9 -9 -4) (max 9 9 -4) (both-sides) (material (matte (color \
   (noise .1 .9 (scale .3))))))"

let sharp () =
  let seen lens =
    Shot.picture
      (Written.scene
         [
           Written.size 16 16;
           "(render (spp 4))";
           "(ambient 1)";
           camera ?lens ();
           board;
         ])
  in
  let largest a b =
    let worst = ref 0. in
    for x = 0 to 15 do
      for y = 0 to 15 do
        let p = Picture.pixel a x y and q = Picture.pixel b x y in
        worst := Float.max !worst (Float.abs (p.Rgb.r -. q.Rgb.r))
      done
    done;
    !worst
  in
  let still = seen None in
  if largest still (seen (Some (0.5, 4.))) > 1e-12 then
    Alcotest.fail "the plane of focus is not sharp";
  if largest still (seen (Some (0.5, 5.))) < 1e-3 then
    Alcotest.fail "what is out of focus is sharp"

(* {1 The disk of a point out of focus} *)

let half = 0.05
let far = 6.

let spark =
  Printf.sprintf
    "(box (min %g %g -6) (max %g %g -6) (both-sides) (material (emitter \
     (radiance 1000))))"
    (-.half) (-.half) half half

let pixels = 64

(* A square spark of side 2·half at a distance [far] fills the part 4·half² of a
   disk of radius A|1 − far/focus| in its plane. *)
let disk radius focus () =
  let s =
    Written.scene
      [
        Written.size pixels pixels;
        "(render (spp 64))";
        camera ~lens:(radius, focus) ();
        spark;
      ]
  in
  let picture = Shot.picture s in
  let blur = radius *. Float.abs (1. -. (far /. focus)) in
  let half_picture = far *. tan (10. *. Float.pi /. 180.) in
  let place i =
    ((2. *. (float_of_int i +. 0.5) /. float_of_int pixels) -. 1.)
    *. half_picture
  in
  let slack = (1.5 *. half) +. (2. *. half_picture /. float_of_int pixels) in
  let inside = ref [] in
  for x = 0 to pixels - 1 do
    for y = 0 to pixels - 1 do
      let from_middle = Float.hypot (place x) (place y) in
      let { Rgb.r; _ } = Picture.pixel picture x y in
      if from_middle < blur -. slack then inside := r :: !inside
      else if from_middle > blur +. slack && r > 0. then
        Alcotest.failf "light %g from the middle, not %g" from_middle blur
    done
  done;
  let expected = 1000. *. 4. *. half *. half /. (Float.pi *. blur *. blur) in
  let m = Measured.of_list !inside in
  if List.length !inside < 100 || not (m.error < 0.1 *. m.mean) then
    Alcotest.failf "%d pixels, %g ± %g: too little is seen"
      (List.length !inside) m.mean m.error;
  Measured.is "the disk" m expected

(* What is nearer than the near plane is not seen, through any part of a lens. *)
let near () =
  let seen near =
    List.exists
      (fun c -> not (Rgb.is_black c))
      (Measured.pixels
         (Written.scene
            [
              Written.size 8 8;
              Written.plain;
              camera ~lens:(0.3, 3.) ~near ();
              "(box (min -9 -9 -2) (max 9 9 -2) (both-sides) (material \
               (emitter (radiance 1))))";
            ]))
  in
  Alcotest.(check bool) "before it" true (seen "(near 1.999)");
  Alcotest.(check bool) "behind it" false (seen "(near 2.001)")

let suite =
  ( "lens",
    [
      Law.example "of aperture 0 it is a pinhole to the bit" pinhole;
      Law.example "a pinhole with all effects is the same" forced;
      Law.example "a power of two leaves the bits" scaled;
      Law.example "what is in focus is sharp" sharp;
      Law.example "a spark beyond is a disk" (disk 0.6 3.);
      Law.example "a spark before is a disk" (disk 1.2 15.);
      Law.example "near holds for all of the lens" near;
    ] )

(* Slabs, balls and half-spaces of glass, in closed form. *)

open Candor_colour
open Candor_oracle

(** The reflectance of a boundary for unpolarised light from index [n] to index
    [m], by the angles' sines and tangents, as in textbooks. *)
let reflectance n m angle =
  if angle = 0. then ((n -. m) /. (n +. m)) ** 2.
  else
    let sine = n *. sin angle /. m in
    if sine >= 1. then 1.
    else
      let bent = asin sine in
      let across = sin (angle -. bent) /. sin (angle +. bent)
      and along = tan (angle -. bent) /. tan (angle +. bent) in
      if n = m then 0. else 0.5 *. ((across ** 2.) +. (along ** 2.))

let refracted n m angle = asin (n *. sin angle /. m)

(** What goes through boundaries one behind the other that lose nothing. *)
let pile reflectances =
  let odds r = r /. (1. -. r) in
  1. /. (1. +. List.fold_left (fun s r -> s +. odds r) 0. reflectances)

let degrees d = d *. Float.pi /. 180.

(* A wall that shines stands behind z = 0; black is all around. *)
let wall =
  "(box (min -1e3 -1e3 -50) (max 1e3 1e3 -40) (material (emitter (radiance \
   1))))"

(* Looks at the origin at this angle to the z axis. *)
let look angle =
  Measure.look
    ~from:(Printf.sprintf "%.17g 0 %.17g" (20. *. sin angle) (20. *. cos angle))
    "0 0 0"

let whitted angle more =
  Measure.v
    ([ look angle; Measure.settings ~spp:1 ~more:"(depth 40) (cutoff 1e-10)" 1 ]
    @ (wall :: more))

let grey = Rgb.grey
let angles = List.map degrees [ 0.; 10.; 30.; 45.; 60.; 75. ]
let steep = List.filter (fun a -> a < 1.1) angles

let slab ?(front = 1.) ?(back = 0.) glass =
  Printf.sprintf
    "(box (min -1e3 -1e3 %.17g) (max 1e3 1e3 %.17g) (material (glass %s)))" back
    front glass

let clear () =
  List.iter
    (fun angle ->
      let r = reflectance 1. 1.5 angle in
      Measure.exactly ~within:1e-8 "a slab"
        (grey (pile [ r; r ]))
        (whitted angle [ slab "(index 1.5)" ]))
    angles

(* Each crossing and each reflection counts the colour, each way through the
   slab what is not absorbed. *)
let coloured () =
  let color = 0.75 and absorption = 0.3 and thick = 2. in
  List.iter
    (fun angle ->
      let r = reflectance 1. 1.5 angle in
      let way = thick /. cos (refracted 1. 1.5 angle) in
      let through = exp (-.absorption *. way) in
      let around = color *. r *. through in
      let t =
        ((color *. (1. -. r)) ** 2.) *. through /. (1. -. (around *. around))
      in
      Measure.exactly ~within:1e-8 "a slab" (grey t)
        (whitted angle
           [ slab ~front:2. "(index 1.5) (color .75) (absorption .3)" ]))
    angles

let channels () =
  let { Measure.mean; _ } =
    whitted 0.
      [ slab "(index 1) (color (rgb 1 .5 .25)) (absorption (rgb 0 1 2))" ]
  in
  let expected = Rgb.v 1. (0.25 *. exp (-1.)) (0.0625 *. exp (-2.)) in
  Measure.exactly "colours by themselves" expected { mean; error = Rgb.black }

let stack angle indices =
  let rec boundaries n angle = function
    | [] -> []
    | m :: rest ->
        reflectance n m angle :: boundaries m (refracted n m angle) rest
  in
  grey (pile (boundaries 1. angle (indices @ [ 1. ])))

(* Water that stands in a glass, as slabs. *)
let nested () =
  List.iter
    (fun angle ->
      Measure.exactly ~within:1e-6 "water within glass"
        (stack angle [ 1.5; 1.33; 1.5 ])
        (whitted angle
           [
             slab ~front:2. ~back:(-1.) "(index 1.5)";
             slab ~front:1. ~back:0. "(index 1.33)";
           ]))
    steep

let overlapping gap () =
  List.iter
    (fun angle ->
      let glass = slab ~front:2. ~back:(1. -. gap) "(index 1.5)"
      and water = slab ~front:1. ~back:0. "(index 1.33)"
      and other = slab ~front:gap ~back:(-1.) "(index 1.5)" in
      let check name slabs =
        Measure.exactly ~within:1e-6 name
          (stack angle [ 1.5; 1.33; 1.5 ])
          (whitted angle slabs)
      in
      check "in the order of the eye" [ glass; water; other ];
      check "against it" [ other; water; glass ];
      check "water first" [ water; glass; other ])
    steep

(* The floor has the ambient light; of what it sends up, the top of the glass
   turns a part back. *)
let standing () =
  let floor =
    "(box (min -1e3 -1e3 -1) (max 1e3 1e3 0) (material (matte (color .5))))"
  and glass = slab ~front:1. ~back:0. "(index 1.5)" in
  List.iter
    (fun angle ->
      let r = reflectance 1. 1.5 angle in
      let check name forms =
        Measure.exactly ~within:1e-9 name
          (grey (0.5 *. (1. -. r)))
          (Measure.v
             ([ look angle; Measure.settings ~spp:1 1; "(ambient 1)" ] @ forms))
      in
      check "floor first" [ floor; glass ];
      check "glass first" [ glass; floor ])
    [ 0.; degrees 30.; degrees 70. ]

(* Through the middle of balls all boundaries are met straight on. *)
let balls () =
  let ball radius index =
    Printf.sprintf
      "(sphere (center 0 0 0) (radius %g) (material (glass (index %g))))" radius
      index
  in
  Measure.exactly ~within:1e-6 "three balls"
    (stack 0. [ 1.5; 1.33; 2.; 1.33; 1.5 ])
    (whitted 0. [ ball 3. 1.5; ball 2. 1.33; ball 1. 2. ])

(* The camera is one unit under the level surface of water; a wall shines above
   and another, in the water, below. *)
let under_water () =
  let wall at shines =
    Printf.sprintf
      "(box (min -1e5 %g -1e5) (max 1e5 %g 1e5) (material (emitter (radiance \
       %g))))"
      at (at +. 1.) shines
  in
  let absorption = 0.125 in
  let view ?(camera = "") angle =
    Measure.v
      [
        Printf.sprintf
          "(camera (perspective (eye 0 -1 0) (look-at %.17g %.17g 0) (up 0 0 \
           1) (fov-y 1e-7) %s))"
          (sin angle)
          (cos angle -. 1.)
          camera;
        Measure.settings ~spp:1 1;
        wall 5. 1.;
        wall (-6.) 2.;
        "(quadric (plane (normal 0 1 0) (offset 0)) (material (glass (index \
         1.33) (absorption .125))))";
      ]
  in
  List.iter
    (fun angle ->
      let r = reflectance 1.33 1. angle in
      let share way = exp (-.absorption *. way /. cos angle) in
      let expected = ((1. -. r) *. share 1.) +. (r *. 2. *. share 6.) in
      Measure.exactly ~within:1e-7 "under water" (grey expected) (view angle);
      Measure.exactly ~within:1e-7 "from a near plane"
        (grey (((1. -. r) *. share 0.5) +. (r *. 2. *. share 5.5)))
        (view ~camera:(Printf.sprintf "(near %.17g)" (0.5 /. cos angle)) angle))
    (List.map degrees [ 0.; 20.; 45.; 48.7; 48.8; 60.; 80. ])

(* Light enters a right-angled prism by one side, is turned by the other, and
   leaves by the third; what the last side turns back comes the same way. *)
let prism () =
  let corners =
    "(polygon (0 0 -9) (4 0 -9) (4 0 9) (0 0 9)) (polygon (0 0 -9) (0 0 9) (0 \
     4 9) (0 4 -9)) (polygon (4 0 9) (4 0 -9) (0 4 -9) (0 4 9)) (polygon (0 0 \
     9) (4 0 9) (0 4 9)) (polygon (0 0 -9) (0 4 -9) (4 0 -9))"
  in
  let shown =
    Measure.v
      [
        Measure.look ~up:"0 0 1" ~from:"-9 1 0" "0 1 0";
        Measure.settings ~spp:1 ~more:"(depth 60) (cutoff 1e-14)" 1;
        "(box (min -9 -9 -9) (max 20 -5 9) (material (emitter (radiance 1))))";
        "(group " ^ corners ^ " (material (glass (index 1.5) (color .9))))";
      ]
  in
  let r = reflectance 1. 1.5 0. and c = 0.9 in
  let t = (c ** 3.) *. ((1. -. r) ** 2.) /. (1. -. ((c ** 4.) *. r *. r)) in
  Measure.exactly ~within:1e-9 "turned" (grey t) shown

(* Both branches everywhere, and one by chance. *)
let both_ways () =
  let scene more =
    [
      look (degrees 30.);
      Measure.settings ~spp:16 ~more 32;
      "(background (rgb .2 .1 .05))";
      wall;
      "(sphere (center 1 0 0) (radius 2) (material (glass (index 1.5) (color \
       .9) (absorption .1))))";
      "(sphere (center -1 1 -6) (radius 3) (material (glass (index 1.33))))";
      "(quadric (plane (normal 0 1 0) (offset -4)) (material (mirror (color \
       .5))))";
    ]
  in
  Measure.is "one by chance" (Measure.v (scene "(depth 30) (cutoff 1e-9)")).mean
    (Measure.v (Measure.indirect :: scene ""))

let suite =
  ( "glass",
    [
      Law.example "a clear slab lets its closed form through" clear;
      Law.example "so does one that colours and absorbs" coloured;
      Law.example "each channel by itself" channels;
      Law.example "water within glass is a pile of plates" nested;
      Law.example "so is water that overlaps with glass" (overlapping 0.125);
      Law.example "and water that touches glass" (overlapping 0.);
      Law.example "glass shows the floor that it stands on" standing;
      Law.example "by however little" (overlapping 0x1p-40);
      Law.example "balls within balls, through the middle" balls;
      Law.example "what a camera under water sees" under_water;
      Law.example "a prism turns light without loss" prism;
      Law.example "both ways or one by chance: the same in the mean" both_ways;
    ] )

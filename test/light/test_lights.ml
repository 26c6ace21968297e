(* Area lights above a white matte floor, in closed form. *)

open Candor_colour
open Candor_oracle
open Candor_space

let floor =
  "(quadric (plane (normal 0 1 0) (offset 0)) (material (matte (color 1))))"

let glow = Rgb.v 5. 3. 1.
let emitter = "(material (emitter (radiance (rgb 5 3 1))))"

(* The floor at the origin, seen aslant from below all lights. *)
let seen ?(n = 16) ?spp ?(from = "4 1 3") ?(floor = floor) more =
  [ Measure.look ~from "0 0 0"; Measure.settings ?spp n; floor ] @ more

(* What a white matte floor shows under this irradiance per radiance. *)
let expected irradiance = Rgb.scale (irradiance /. Float.pi) glow

(* By the lights alone, by both ways together, by the floor's paths alone. *)
let three ?n ?floor ?within ?(loosely = 0.05) name irradiance lights =
  let expected = expected irradiance in
  let whitted = seen ?n ?floor lights in
  let path = Measure.indirect :: whitted in
  Measure.is ?within (name ^ ", by the light") expected (Measure.v whitted);
  Measure.is ?within (name ^ ", both ways") expected (Measure.v path);
  Measure.is ~within:loosely (name ^ ", by the floor") expected
    (Measure.changed Measure.by_material path)

(* π (r/d)² cos, for a ball that is wholly above the floor. *)
let ball (x, y, z) radius =
  let square = (x *. x) +. (y *. y) +. (z *. z) in
  Float.pi *. radius *. radius /. square *. (y /. sqrt square)

let sphere (x, y, z) radius =
  Printf.sprintf "(sphere (center %g %g %g) (radius %g) %s)" x y z radius
    emitter

let balls () =
  let check name center radius =
    three ~n:24 name (ball center radius) [ sphere center radius ]
  in
  check "a ball overhead" (0., 3., 0.) 1.;
  check "a ball aside" (-1., 2., 1.) 0.75;
  check "a far ball" (1., 4., -2.) 1.

let near_and_far () =
  let light center radius =
    Measure.is "by the light"
      (expected (ball center radius))
      (Measure.v (seen ~from:"4 .1 3" [ sphere center radius ]))
  in
  light (0., 1.01, 0.) 1.;
  light (3e5, 4e5, 0.) 1.;
  light (0., 2e-3, 0.) 1e-3

let other_balls () =
  let irradiance = ball (-1., 2., 1.) 0.75 in
  three "an ellipsoid" irradiance
    [
      "(quadric (ellipsoid (center -1 2 1) (radii .75 .75 .75)) " ^ emitter
      ^ ")";
    ];
  three "a ball that is scaled and moved" irradiance
    [
      "(group (transform (scale .25) (translate -1 2 1)) (sphere (center 0 0 \
       0) (radius 3) " ^ emitter ^ "))";
    ]

(* Lambert's formula: half the sum over the edges of the angle that each fills
   times the cosine of its plane's normal. *)
let polygon corners =
  let unit (x, y, z) = Option.get (Dir.of_vec (Vec.v x y z)) in
  let corners = Array.of_list (List.map unit corners) in
  let n = Array.length corners in
  let edge i =
    let a = (corners.(i) :> Vec.t) and b = (corners.((i + 1) mod n) :> Vec.t) in
    let across = Vec.cross a b in
    let sine = Vec.norm across in
    Float.atan2 sine (Vec.dot a b) *. across.y /. sine
  in
  Float.abs (List.fold_left (fun s i -> s +. edge i) 0. (List.init n Fun.id))
  /. 2.

let point (x, y, z) = Printf.sprintf "(%g %g %g)" x y z

let flat kind corners more =
  Printf.sprintf "(%s %s %s %s)" kind
    (String.concat " " (List.map point corners))
    emitter more

(* Corners run counter-clockwise as seen from the floor. *)
let triangle = [ (-1., 2., 0.); (1., 2.5, 0.5); (0.5, 1.5, 2.) ]
let square = [ (0.5, 2., -1.); (2.5, 2., -1.); (2.5, 2., 1.); (0.5, 2., 1.) ]
let arrow = [ (-2., 2., -2.); (0., 2., -0.5); (2., 2., -2.); (0., 2., 2.) ]

let polygons () =
  three "a triangle" (polygon triangle) [ flat "triangle" triangle "" ];
  three "a square" (polygon square) [ flat "polygon" square "" ];
  three "a flat box" (polygon square)
    [ "(box (min .5 2 -1) (max 2.5 2 1) " ^ emitter ^ ")" ];
  three "an arrow" (polygon arrow) [ flat "polygon" arrow "" ];
  three "a square upside down that shines on both sides" (polygon square)
    [ flat "polygon" (List.rev square) "(both-sides)" ]

let one_side () =
  let dark corners kind =
    Measure.exactly kind Rgb.black
      (Measure.v (Measure.indirect :: seen [ flat kind corners "" ]))
  in
  dark (List.rev triangle) "triangle";
  dark (List.rev square) "polygon"

(* The three faces that the floor sees of a box, each a polygon. *)
let boxes () =
  let bottom = [ (1., 1., 1.); (2., 1., 1.); (2., 1., 3.); (1., 1., 3.) ]
  and left = [ (1., 1., 1.); (1., 2., 1.); (1., 2., 3.); (1., 1., 3.) ]
  and front = [ (1., 1., 1.); (2., 1., 1.); (2., 2., 1.); (1., 2., 1.) ] in
  let irradiance = polygon bottom +. polygon left +. polygon front in
  three ~n:24 "a box" irradiance
    [ "(box (min 1 1 1) (max 2 2 3) " ^ emitter ^ ")" ]

(* The end of a cylinder over its axis is a disk: π r²/(h² + r²). *)
let disks () =
  let disk h r = Float.pi *. r *. r /. ((h *. h) +. (r *. r)) in
  three ~n:40 "the end of a cylinder" (disk 2. 1.)
    [
      "(quadric (cylinder (from 0 2 0) (to 0 3 0) (radius 1)) (caps) " ^ emitter
      ^ ")";
    ];
  three ~n:32 "the base of a cone" (disk 1.5 0.5)
    [
      "(quadric (cone (apex 0 4 0) (base 0 1.5 0) (radius .5)) (caps) "
      ^ emitter ^ ")";
    ]

(* Several lights, of which one is chosen, add up. *)
let many () =
  let centers =
    List.init 12 (fun i ->
        let a = float_of_int i in
        (3. *. cos a, 1.5 +. (0.25 *. a), 3. *. sin a))
  in
  let irradiance = List.fold_left (fun sum c -> sum +. ball c 0.4) 0. centers in
  three ~n:24 ~loosely:0.1 "twelve balls" irradiance
    (List.map (fun c -> sphere c 0.4) centers)

(* Half of a light below the horizon gives what half a disk does. *)
let horizon () =
  let reference =
    Measure.changed Measure.by_material
      (Measure.indirect :: seen ~n:48 [ sphere (0., 0.2, 2.) 1. ])
  in
  Measure.agree ~within:0.03 "by the light and by the floor"
    (Measure.v (seen ~n:24 [ sphere (0., 0.2, 2.) 1. ]))
    reference

(* The blocker, seen from the origin, hides exactly one of two equal squares. *)
let shadow () =
  let one = [ (0.5, 2., -1.); (2.5, 2., -1.); (2.5, 2., 1.); (0.5, 2., 1.) ] in
  let other = List.map (fun (x, y, z) -> (-.x, y, z)) one in
  three "half of the light in shadow" (polygon one)
    [
      flat "polygon" one "";
      flat "polygon" (List.rev other) "";
      "(box (min -2 1 -1) (max 0 1 1) (material (matte (color 0))))";
    ]

let seen_directly () =
  let look shape =
    Measure.v [ Measure.look ~from:"0 0 9" "0 0 0"; Measure.settings 4; shape ]
  in
  Measure.exactly "an emitter" glow
    (look ("(sphere (center 0 0 0) (radius 1) " ^ emitter ^ ")"));
  Measure.exactly "from behind" Rgb.black
    (look (flat "triangle" [ (-9., -9., 0.); (0., 9., 0.); (9., -9., 0.) ] ""));
  Measure.exactly "from behind, of both sides" glow
    (look
       (flat "triangle"
          [ (-9., -9., 0.); (0., 9., 0.); (9., -9., 0.) ]
          "(both-sides)"));
  Measure.exactly "matte that emits" glow
    (look
       "(sphere (center 0 0 0) (radius 1) (material (matte (color .5) \
        (emission (rgb 5 3 1)))))")

let suite =
  ( "lights",
    [
      Law.example "a ball of light: irradiance is pi L (r/d)^2 cos" balls;
      Law.example "very near, very far and very small ones, too" near_and_far;
      Law.example "whatever the ball is written as" other_balls;
      Law.example "polygons: Lambert's formula" polygons;
      Law.example "no light comes from the other side" one_side;
      Law.example "a box is its faces" boxes;
      Law.example "the ends of cylinders and cones are disks" disks;
      Law.example "many lights add up" many;
      Law.example "a light on the horizon is what shows of it" horizon;
      Law.example "what a surface hides is missing, and nothing else" shadow;
      Law.example "lights are seen as bright as they are" seen_directly;
    ] )

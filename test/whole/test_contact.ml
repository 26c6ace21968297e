open Candor_space
open Candor_surface
open Candor_trace
open Candor_oracle
open Candor_scene_made
open Expected
open Rooms

(* {1 Contact} *)

(* Where the camera ray of pixel (x, y) meets the floor y = 0 of the scene as
   written, and what it meets first. *)
let look forms =
  let unit = Written.scene forms in
  let pixel = Pixel.compile unit in
  fun x y ->
    let ray = Pixel.ray pixel ~x ~y ~sample:0 in
    let o = ray.origin and d = ray.direction in
    let first =
      Option.map
        (fun (h : _ Hit.t) -> List.hd h.path)
        (Surface.nearest (Pixel.surface pixel) ray)
    in
    (first, Point.along o d (-.o.y /. d.y))

(* How far within a shadow; no pixel may be too near its border to tell. *)
let shadowed depth =
  if Float.abs depth < 1e-9 then Alcotest.failf "a border pixel: %g" depth;
  if depth > 0. then Black else Lit

let floors =
  [
    ("a plane", "(quadric (plane (normal 0 1 0) (offset 0)))");
    ("a box", "(box (min -9 -1 -9) (max 9 0 9))");
    ( "two triangles",
      group
        [
          "(triangle (-9 0 -9) (-9 0 9) (9 0 9))";
          "(triangle (-9 0 -9) (9 0 9) (9 0 -9))";
        ] );
  ]

(* What stands on the floor, and how deep in its shadow (x, z) of the floor is,
   the light coming from above or along (1 -1 0). *)
let standing_on_it =
  [
    ( "a sphere",
      "(sphere (center 0 1 0) (radius 1))",
      "0 -1 0",
      fun x z -> 1. -. (x *. x) -. (z *. z) );
    ( "a box",
      "(box (min -1 0 -1) (max 1 2 1))",
      "1 -1 0",
      fun x z -> Float.min (1. -. Float.abs z) (Float.min (x +. 1.) (3. -. x))
    );
    ( "a cylinder",
      "(quadric (cylinder (from 0 0 0) (to 0 2 0) (radius 1)) (caps))",
      "0 -1 0",
      fun x z -> 1. -. (x *. x) -. (z *. z) );
  ]

let contact (floor_name, floor) (name, body, direction, depth) =
  Law.example
    (Printf.sprintf "G21 G23: %s resting exactly on %s casts its whole shadow"
       name floor_name) (fun () ->
      let forms =
        [
          Written.size 32 32;
          Written.plain;
          perspective "2.5 1.3 4.1" "0.03 .4 .07" "45";
          sun direction;
          floor;
          body;
        ]
      in
      let look = look forms in
      everywhere ~lit:300 forms
        (fun x y ->
          match look x y with
          | Some 0, p -> shadowed (depth p.x p.z)
          | (Some _ | None), _ -> Lit)
        ())

(* The gap at distance e from the contact is e²/2 high. *)
let under_the_ball (floor_name, floor) =
  Law.example
    (Printf.sprintf
       "G23: under a sphere resting on %s it is dark down to the contact"
       floor_name) (fun () ->
      List.iter
        (fun k ->
          let e = Float.ldexp 1. (-k) in
          let eye = Printf.sprintf "%h %h %h" e (e *. e /. 4.) 0. in
          everywhere ~lit:0
            [
              size;
              Written.plain;
              perspective eye "0 0 0" "20";
              sun "0 -1 0";
              point_light "0.25 9 .5";
              point_light "5 2 1";
              floor;
              "(sphere (center 0 1 0) (radius 1))";
            ]
            (fun _ _ -> Black)
            ())
        [ 5; 10; 15; 20 ])

(* Lit floor up to the wall that stands on it, dark floor behind. *)
let foot (floor_name, floor) =
  let zoom = [ "30"; ".03"; ".00003" ] in
  let seen edge expected fov =
    let forms =
      [
        size;
        Written.plain;
        perspective
          (if edge < 0 then "-4.1 1.3 .7" else "4.1 1.3 .7")
          (Printf.sprintf "%d 0 .1" edge)
          fov;
        sun "1 -1 0";
        floor;
        "(box (min -1 0 -1) (max 1 2 1))";
      ]
    in
    let look = look forms in
    everywhere
      ~lit:(if edge < 0 then 500 else 200)
      forms
      (fun x y ->
        match look x y with
        | Some 0, p when Float.abs p.z < 0.9 && Float.abs p.x < 2.9 -> expected
        | Some 1, _ -> Lit
        | Some 0, p ->
            shadowed
              (Float.min
                 (1. -. Float.abs p.z)
                 (Float.min (p.x +. 1.) (3. -. p.x)))
        | (Some _ | None), _ -> Lit)
      ()
  in
  Law.example
    (Printf.sprintf
       "G21: the shadow of a box on %s begins at its foot, to the pixel"
       floor_name) (fun () ->
      List.iter (seen (-1) Lit) zoom;
      List.iter (seen 1 Black) zoom)

(* {1 Lights on and beside surfaces} *)

let lamp ?standings ?sizes (name, room) at =
  Law.example
    (Printf.sprintf "G21: a lamp in %s at (%s) lights it all" name at)
    (everywhere ?standings ?sizes ~lit:300
       [
         size;
         Written.plain;
         perspective ".1 .2 .3" "-1 -1 -1" "80";
         point_light at;
         room;
       ]
       (fun _ _ -> Lit))

(* Where the sizes are powers of two the lamp stays exactly where it is. *)
let lamp_on_wall room =
  lamp ~standings:[ Plain; Instanced ] ~sizes:Standing.powers room "0 1 0"

let named names = List.filter (fun (name, _) -> List.mem name names) rooms

let high =
  named
    [
      "a sphere";
      "a box";
      "a cylinder";
      "a paraboloid";
      "twelve triangles";
      "six planes";
      "six spheres";
    ]

let suite =
  ( "contact",
    List.concat
      [
        List.concat_map
          (fun floor -> List.map (contact floor) standing_on_it)
          floors;
        List.map under_the_ball floors;
        List.map foot floors;
        List.map (fun room -> lamp room "0 .999999999 0") high;
        List.map lamp_on_wall
          (named
             [
               "a box";
               "twelve triangles";
               "six planes";
               "a sphere";
               "a cylinder";
               "a paraboloid";
               "an octahedron";
               "six spheres";
             ]);
      ] )

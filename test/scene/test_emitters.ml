open Candor_space
open Candor_colour
open Candor_surface
open Candor_scene
open Candor_oracle

let valid = function Ok x -> x | Error why -> Alcotest.fail why

let camera =
  {
    Camera.eye = Point.v 0. 0. 9.;
    look_at = Point.origin;
    up = Vec.v 0. 1. 0.;
    frame = Orthographic_height { height = 2. };
    near = None;
    lens = None;
    shutter = { opens = 0.; closes = 1. };
    place = Place.unknown;
  }

let scene ?(materials = []) ?(definitions = []) surfaces =
  let named (name, value) = { Scene.name; value; place = Place.unknown } in
  {
    Scene.width = 1;
    height = 1;
    camera;
    background = Uniform Rgb.black;
    ambient = None;
    indirect = None;
    fog = None;
    settings = Scene.default_settings;
    lights = [];
    materials = List.map named materials;
    definitions = List.map named definitions;
    surfaces;
  }

let glow k = { Material.kind = Emitter; emission = Rgb.grey k }
let lit k = Some (Scene.Inline (glow k))
let plain shape = Scene.plain shape Place.unknown

let ball x =
  plain (Sphere (valid (Sphere.make ~center:(Point.v x 0. 0.) ~radius:0.4)))

let glowing k s = { s with Scene.material = lit k }
let group ?(transform = []) surfaces = plain (Group { transform; surfaces })
let use ?(transform = []) name = plain (Use { transform; name })
let moving v s = { s with Scene.motion = v }
let shift x = [ Transform.Translate (Vec.v x 0. 0.) ]
let show_path path = String.concat "." (List.map string_of_int path)

let check name expected scene =
  let shown (e : Emitters.t) =
    Printf.sprintf "%s:%g" (show_path e.path) (Emitters.radiance e).r
  in
  Alcotest.(check (list string))
    name expected
    (List.map shown (Emitters.of_scene scene))

let order () =
  check "own, a group's and a name's emission, in the order of paths"
    [ "0:1"; "2.0:3"; "2.1:2"; "2.2.0:3"; "3:4" ]
    (scene
       ~materials:[ ("lamp", glow 4.) ]
       [
         glowing 1. (ball 0.);
         ball 1.;
         glowing 3. (group [ ball 2.; glowing 2. (ball 3.); group [ ball 4. ] ]);
         { (ball 5.) with material = Some (Named "lamp") };
         { (ball 6.) with material = Some (Named "nothing") };
       ])

let uses () =
  check "each use of a definition counts, with what it is given"
    [ "0.0:1"; "1.0:1"; "1.1.0:5"; "2.1.0:7" ]
    (scene
       ~definitions:
         [
           ("one", [ glowing 1. (ball 0.) ]);
           ("two", [ glowing 1. (ball 0.); use "dim" ]);
           ("dim", [ ball 2. ]);
         ]
       [
         use "one";
         glowing 5. (use "two");
         group [ ball 0.; glowing 7. (use "dim") ];
       ])

(* 2^60 dark balls. *)
let deep () =
  let name i = Printf.sprintf "d%d" i in
  let definitions =
    List.init 60 (fun i -> (name i, [ use (name (i + 1)); use (name (i + 1)) ]))
    @ [ (name 60, [ ball 0. ]) ]
  in
  check "what is dark is not counted out" [ "1:1" ]
    (scene ~definitions [ use "d0"; glowing 1. (ball 9.) ])

let polygons () =
  let corners =
    [ Point.v 0. 0. 0.; Point.v 1. 0. 0.; Point.v 1. 1. 0.; Point.v 0. 1. 0. ]
  in
  check "polygons give their triangles" [ "0.0:2"; "0.1:2" ]
    (scene [ glowing 2. (plain (Polygon (valid (Polygon.make corners)))) ])

let scenes =
  let turn = Transform.Rotate { axis = Vec.v 1. 2. 3.; degrees = 50. } in
  scene
    ~definitions:
      [
        ("pair", [ ball 0.; moving (Vec.v 0. 1. 0.) (glowing 3. (ball 2.)) ]);
        ( "nest",
          [ group ~transform:[ turn ] [ use ~transform:(shift 3.) "pair" ] ] );
      ]
    [
      { (glowing 1. (ball 0.)) with both_sides = true };
      moving (Vec.v 0. 0. 2.)
        (group
           ~transform:[ Scale (Vec.v 1. 2. 1.); Translate (Vec.v 5. 0. 0.) ]
           [ moving (Vec.v 1. 0. 0.) (use ~transform:[ turn ] "pair") ]);
      {
        (glowing 2. (use ~transform:(shift (-7.)) "nest")) with
        both_sides = true;
      };
    ]

(* Where the middle of a ball in the world is at a time. *)
let middle time (e : Emitters.t) =
  match e.shape with
  | Sphere s ->
      let at = Sphere.center s in
      let at =
        match e.transform with
        | None -> at
        | Some m -> Affine.point (Transform.forward m).high at
      in
      Point.add at (Vec.scale time e.velocity)
  | Box _ | Triangle _ | Quadric _ -> Alcotest.fail "not a ball"

let found () =
  let surface = Assembly.surface ~dress:Fun.id scenes in
  let meets time (e : Emitters.t) d =
    let from = Point.v 1. 30. (-20.) in
    let way = Point.sub (Point.add (middle time e) d) from in
    match Surface.nearest surface ~time (Ray.v from way) with
    | Some hit when hit.path = e.path ->
        Material.equal hit.material.material e.material
        && hit.material.both_sides = e.both_sides
    | Some _ | None -> false
  in
  let emitters = Emitters.of_scene scenes in
  Alcotest.(check (list string))
    "paths"
    [ "0"; "1.0.1"; "2.0.0.0"; "2.0.0.1" ]
    (List.map (fun (e : Emitters.t) -> show_path e.path) emitters);
  List.iter
    (fun e ->
      List.iter
        (fun time ->
          if not (meets time e (Vec.v 0.05 (-0.1) 0.1)) then
            Alcotest.failf "%s is not met at %g" (show_path e.path) time)
        [ 0.; 0.25; 1. ])
    emitters

let suite =
  ( "emitters",
    [
      Law.example "materials are inherited as in the assembly" order;
      Law.example "shared definitions emit wherever they are used" uses;
      Law.example "dark definitions cost nothing" deep;
      Law.example "a polygon is its triangles" polygons;
      Law.example "rays to where an emitter is at a time report its path" found;
    ] )

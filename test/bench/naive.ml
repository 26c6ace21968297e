(* What stability costs: whole renders with Candor's math and with the
   textbook's, turn by turn, in seconds of one processor. *)

open Candor_space
open Candor_surface
open Candor_scene
open Candor_render
open Candor_trace

let turns = 5

(* {1 A mesh}

   A torus of [2 n m] triangles over a floor, in place of a scene's surfaces. *)

let valid = function
  | Ok x -> x
  | Error why ->
      prerr_endline ("bench: " ^ why);
      exit 1

let on_torus ~n ~m i j =
  let turn i n = 2. *. Float.pi *. float_of_int (i mod n) /. float_of_int n in
  let u = turn i n and v = turn j m in
  let r = 2. +. (0.8 *. cos v) in
  Point.v (r *. cos u) (0.9 +. (0.8 *. sin v)) (r *. sin u)

let torus ~n ~m =
  let at = on_torus ~n ~m in
  let quad k =
    let i = k / m and j = k mod m in
    let a = at i j and b = at (i + 1) j in
    let c = at (i + 1) (j + 1) and d = at i (j + 1) in
    [ { Triangle.a; b = d; c }; { Triangle.a; b = c; c = b } ]
  in
  List.concat_map quad (List.init (n * m) Fun.id)
  |> List.map (fun corners -> valid (Triangle.make corners))

let mesh (scene : Scene.t) =
  let surface shape = Scene.plain shape Place.unknown in
  let triangle t = surface (Scene.Triangle t) in
  let triangles = List.map triangle (torus ~n:250 ~m:200) in
  let floor =
    valid (Box.make ~min:(Point.v (-9.) (-0.2) (-9.)) ~max:(Point.v 9. 0.1 9.))
  in
  {
    scene with
    surfaces =
      [
        surface (Box floor);
        surface (Group { transform = []; surfaces = triangles });
      ];
  }

(* {1 Measuring} *)

let seconds math (scene : Scene.t) =
  let pixel = Pixel.compile ~math scene in
  fst (Turns.processor (fun () -> Render.run ~domains:1 pixel scene))

let row name scene =
  let scene =
    { scene with Scene.settings = { scene.Scene.settings with spp = 1 } }
  in
  let turn _ =
    let stable = seconds Stable scene in
    (stable, seconds Textbook scene)
  in
  let all = List.init turns turn in
  let ratio = Turns.median (List.map (fun (s, t) -> s /. t) all) in
  Printf.printf "%-26s %10.2f %10.2f %8.2f %8s\n%!" name
    (Turns.median (List.map fst all))
    (Turns.median (List.map snd all))
    ratio
    (if ratio <= 1.25 then "met" else "missed")

let table folder =
  Printf.printf "%-26s %10s %10s %8s %8s\n" "scene (1 spp)" "Candor s"
    "textbook s" "ratio" "<= 1.25";
  row "sphereflake-flat" (Load.named folder "sphereflake-flat");
  row "sphereflake (nested)" (Load.named folder "sphereflake");
  row "quadrics" (Load.named folder "quadrics");
  row "100,000 triangles" (mesh (Load.named folder "quadrics"))

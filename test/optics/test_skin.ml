open Candor_space
open Candor_surface
open Candor_scene
open Candor_optics
open Candor_oracle
open Candor_scene_made

let scene =
  Written.scene
    [
      Written.flat_camera;
      "(material glass (glass (index 1.5)))";
      "(material paint (matte (color .25)))";
      "(sphere (center 0 0 0) (radius 1) (material glass))";
      "(sphere (center 4 0 0) (radius 1) (material glass))";
      "(box (min 8 -1 -1) (max 9 1 1) (material (emitter (radiance 2))) \
       (both-sides))";
      "(group (material paint) (sphere (center 12 0 0) (radius 1)))";
      "(sphere (center 16 0 0) (radius 1))";
    ]

let skin x : Skin.t =
  let ray = Ray.v (Point.v x 0. 5.) (Vec.v 0. 0. (-1.)) in
  match Surface.nearest (Skin.surface scene) ray with
  | Some hit -> hit.material
  | None -> Alcotest.fail "the ray meets nothing"

let carries () =
  let is name m x =
    Alcotest.(check bool) name true (Material.equal m (skin x).material)
  in
  let named n =
    (List.find (fun (m : _ Scene.named) -> m.name = n) scene.materials).value
  in
  is "its own" (named "glass") 0.;
  is "its group's" (named "paint") 12.;
  is "none" Material.default 16.;
  Alcotest.(check (list bool))
    "whether it emits from both sides"
    [ false; false; true; false; false ]
    (List.map (fun x -> (skin x).both_sides) [ 0.; 4.; 8.5; 12.; 16. ])

(* Bodies of glass are told apart by their materials' identity. *)
let shared () =
  Alcotest.(check bool)
    "one material is one value" true
    ((skin 0.).material == (skin 4.).material)

let places () =
  Alcotest.(check int) "the line" 5 (skin 0.).place.line;
  Alcotest.(check int) "another line" 7 (skin 8.5).place.line

let lobes () =
  let here = Drawn.some_point in
  let { Local.normal; _ } = here in
  let diffuse x =
    ((skin x).lobes here ~normal ~view:(normal :> Vec.t)).diffuse
  in
  Near.rgb "paint" (Candor_colour.Rgb.grey 0.25) (diffuse 12.);
  Near.rgb "the default" (Candor_colour.Rgb.grey 0.5) (diffuse 16.);
  Near.rgb "glass" Candor_colour.Rgb.black (diffuse 0.)

let suite =
  ( "skins",
    [
      Law.example "a surface has its own material, its group's, or the default"
        carries;
      Law.example "a material that has a name is one value" shared;
      Law.example "skins know where they are written" places;
      Law.example "and what they do with light" lobes;
    ] )

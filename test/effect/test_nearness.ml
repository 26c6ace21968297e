open Candor_space
open Candor_surface
open Candor_effect
open Candor_oracle
open Candor_scene_made

let from forms (x, y, z) =
  Nearness.to_surfaces (Lit.scene forms) (Point.v x y z)

let known () =
  let near name expected d =
    if not (Lit.close ~within:1e-9 d expected) then
      Alcotest.failf "%s: expected %g, got %.17g" name expected d
  in
  let ball = "(sphere (center 1 0 0) (radius 2))" in
  near "outside a sphere" 3. (from [ ball ] (6., 0., 0.));
  near "inside a sphere" 1.5 (from [ ball ] (1., 0.5, 0.));
  near "a plane" 2.
    (from [ "(quadric (plane (normal 0 3 4) (offset 10)))" ] (7., 0., 0.));
  let box = "(box (min 0 0 0) (max 2 4 6))" in
  near "inside a box" 0.5 (from [ box ] (1., 2., 5.5));
  near "beyond an edge" 5. (from [ box ] (5., 8., 3.));
  near "two surfaces" 1. (from [ ball; box ] (1., 5., 1.));
  near "inside a sphere in a group" 1.5
    (from [ "(group (group " ^ ball ^ "))" ] (1., 0.5, 0.));
  near "in a group" 5.
    (from [ "(group (transform (translate 0 0 -7)) " ^ box ^ ")" ] (1., 1., 4.))

let unknown () =
  let is name expected d = Alcotest.(check (float 0.)) name expected d in
  is "nothing" infinity (from [] (0., 0., 0.));
  is "a surface without end" 0.
    (from
       [ "(quadric (hyperboloid-one-sheet (center 0 0 0) (radii 1 1 1)))" ]
       (0., 0., 0.));
  is "inside of what is moved" 0.
    (from
       [ "(group (transform (scale 2)) (sphere (center 0 0 0) (radius 1)))" ]
       (0., 0., 0.));
  is "in the way of what moves" 0.
    (from [ "(sphere (center 0 0 0) (radius 1) (motion 4 0 0))" ] (0.5, 0., 0.))

(* Whatever rays from a point meet is no nearer. *)
let lower (scene, (p : Point.t), directions) =
  let distance = Nearness.to_surfaces scene p in
  let surface = Candor_optics.Skin.surface scene in
  List.for_all
    (fun d ->
      match Surface.nearest surface (Ray.v p d) with
      | None -> true
      | Some hit -> hit.t *. Vec.norm d >= distance)
    directions

let cases style =
  QCheck2.Gen.(
    triple (Drawn.scene style)
      (Draw.point (Draw.uniform (-5.) 5.))
      (list_size (return 60) Draw.unit))

let law name style =
  Law.law ~count:300
    ~print:(fun (s, p, _) -> Drawn.show s ^ Draw.show_point p)
    name (cases style) lower

let suite =
  ( "nearness",
    [
      Law.example "spheres, boxes and planes count as they are" known;
      Law.example "of others less is known" unknown;
      law "no surface is nearer" Drawn.Loose;
      law "no surface is nearer, however they touch" Drawn.Round;
    ] )

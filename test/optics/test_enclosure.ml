open Candor_space
open Candor_surface
open Candor_scene
open Candor_optics
open Candor_oracle
open Lit

let light_center = p 50. (681.6 -. 0.27) 81.6

let smallpt_cap () =
  let walls = Enclosure.of_scene smallpt in
  match Enclosure.best walls ~center:light_center ~radius:600. with
  | Some (wall, Cap { axis; one_minus_cos = h }) ->
      let rim = 600. *. sqrt (h *. (2. -. h)) in
      (* The ceiling is not quite flat: its sphere takes a little. *)
      let fall = 0.27 and rc = 1e5 in
      let exact = sqrt (2. *. fall *. (600. *. rc /. (600. +. rc))) in
      Near.float ~within:1e-3 "the radius of the cap" exact rim;
      Near.vec ~within:1e-6 "its axis" (0., -1., 0.) (axis :> Vec.t);
      let on side path = Ray.Surface { path; part = 0; side } in
      let shields = Enclosure.shields wall in
      let check name expected ~departure at =
        Alcotest.(check bool) name expected (shields ~departure at)
      in
      check "the floor" true ~departure:(on Inside [ 4 ]) (p 50. 0. 80.);
      check "the ceiling, from inside" true ~departure:(on Inside [ 5 ])
        (p 50. 81.6 81.6);
      check "the ceiling, from outside" false ~departure:(on Outside [ 5 ])
        (p 50. 81.6 81.6);
      check "somewhere on the ceiling" false ~departure:Nowhere
        (p 50. 81.6 81.6);
      check "above it" false ~departure:Nowhere (p 50. 81.7 81.6)
  | Some (_, (Whole | Nothing)) | None -> Alcotest.fail "no cap"

let count walls center radius =
  match Enclosure.best walls ~center ~radius with
  | None -> "whole"
  | Some (_, Whole) -> "all"
  | Some (_, Nothing) -> "nothing"
  | Some (_, Cap { one_minus_cos; _ }) -> Printf.sprintf "%.6f" one_minus_cos

let check name surfaces expected =
  let walls = Enclosure.of_scene (scene surfaces) in
  Alcotest.(check string) name expected (count walls (p 0. 2. 0.) 1.)

(* The camera is at (0 0 9); the light at (0 2 0) has radius 1. *)
let kinds () =
  let plane y material =
    made material
      (Quadric (quadric (Plane { normal = Vec.v 0. 3. 0.; offset = 3. *. y })))
  and room y = made matte (Box (box (p (-20.) (-20.) (-20.)) (p 20. y 20.))) in
  check "below a plane" [ plane 1.5 matte ] "0.500000";
  check "just below a plane" [ plane 1. matte ] "0.000000";
  check "a plane beyond" [ plane 0.9 matte ] "nothing";
  check "a plane above it" [ plane 3.5 matte ] "whole";
  check "below both" [ plane 1.5 matte; plane 1.25 matte ] "0.250000";
  check "a glass plane" [ plane 1.5 glass ] "whole";
  check "a clipped plane"
    [
      made matte
        (Quadric
           (quadric
              ~clip:(Bounds.v (p (-9.) (-9.) (-9.)) (p 9. 9. 9.))
              (Plane { normal = Vec.v 0. 1. 0.; offset = 1.5 })));
    ]
    "whole";
  check "a plane that moves"
    [ { (plane 1.5 matte) with motion = Vec.v 0. 1. 0. } ]
    "whole";
  check "in a group that moves"
    [ { (moved [] [ plane 1.5 matte ]) with motion = Vec.v 0. 1. 0. } ]
    "whole";
  check "in a group"
    [
      moved
        [ Scale (Vec.v 1. (-0.5) 1.); Translate (Vec.v 0. 1. 0.) ]
        [ plane (-1.) matte ];
    ]
    "0.500000";
  check "in a room" [ room 1.5 ] "0.500000";
  check "in a tilted room, a half turn"
    [
      moved
        [ Rotate { axis = Vec.v 0. 0. 1.; degrees = 180. } ]
        [ made matte (Box (box (p (-20.) (-1.5) (-20.)) (p 20. 20. 20.))) ];
    ]
    "0.500000";
  check "outside a box"
    [ made matte (Box (box (p (-2.) 0. (-2.)) (p 2. 4. 2.))) ]
    "whole";
  check "in a large sphere" [ ball matte (p 0. (-98.5) 0.) 100. ] "0.496269";
  check "outside a sphere that holds it"
    [ ball matte (p 0. 2. 0.) 1.5 ]
    "nothing";
  check "outside a sphere that holds half of it"
    [ ball matte (p 0. 2. 1.) (sqrt 2.) ]
    "1.000000";
  check "outside a glass sphere" [ ball glass (p 0. 2. 0.) 1.5 ] "whole";
  check "outside itself" [ ball (glow 1.) (p 0. 2. 0.) 1. ] "whole";
  check "a squeezed sphere"
    [ moved [ Scale (Vec.v 1. 1. 1.1) ] [ ball matte (p 0. 2. 0.) 1.5 ] ]
    "whole"

(* {1 Laws} *)

open QCheck2.Gen

let case =
  let* c = Draw.point (Draw.snapped (Draw.uniform (-3.) 3.))
  and* radius = Draw.uniform 0.1 4.
  and* wall =
    oneof
      [
        (let+ c = Draw.point (Draw.snapped (Draw.uniform (-3.) 3.))
         and+ r = oneof [ Draw.uniform 0.1 5.; Draw.uniform 90. 100. ] in
         ball matte c r);
        (let+ normal = Draw.unit and+ offset = Draw.uniform (-3.) 3. in
         made matte (Quadric (quadric (Plane { normal; offset }))));
        (let+ c = Draw.point (Draw.uniform 10. 20.) in
         made matte (Box (box (p (-.c.x) (-.c.y) (-.c.z)) c)));
      ]
  and* d = Draw.unit in
  return (c, radius, wall, d)

let show (c, radius, (wall : Scene.surface), d) =
  Printf.sprintf "light at %s of radius %h, wall %s, towards %s"
    (Draw.show_point c) radius
    (Scene.show_shape wall.shape)
    (Draw.show_vec d)

(* A point of the light that the wall shields is in its cap. *)
let holds (center, radius, wall, d) =
  match
    Enclosure.best (Enclosure.of_scene (scene [ wall ])) ~center ~radius
  with
  | None -> true
  | Some (w, part) -> (
      let at = Point.add center (Vec.scale radius d) in
      let near = Enclosure.shields w ~departure:Nowhere at in
      match part with
      | Whole -> true
      | Nothing -> not near
      | Cap { axis; one_minus_cos } ->
          let apart = Vec.sub d (axis :> Vec.t) in
          let rise = 0.5 *. Vec.dot apart apart in
          (* It is no larger than it has to be, either. *)
          if near then rise <= one_minus_cos
          else
            rise >= one_minus_cos *. (1. -. 1e-6)
            || one_minus_cos -. rise < 1e-7)

(* Whatever connects a shielded point with what is left out meets the wall. *)
let blocks (center, radius, wall, d) =
  let scene = scene [ wall ] in
  match Enclosure.best (Enclosure.of_scene scene) ~center ~radius with
  | None | Some (_, Whole) -> true
  | Some (w, part) ->
      let at = Point.add center (Vec.scale radius d) in
      let left_out =
        match part with
        | Whole -> false
        | Nothing -> true
        | Cap { axis; one_minus_cos } ->
            let apart = Vec.sub d (axis :> Vec.t) in
            0.5 *. Vec.dot apart apart > one_minus_cos +. 1e-6
      in
      let from = p 0.3 0.1 8. in
      (not (left_out && Enclosure.shields w ~departure:Nowhere from))
      || Surface.blocked
           (Assembly.surface ~dress:ignore scene)
           ~limit:1.
           (Ray.toward at (Ray.v from (Vec.v 0. 0. 1.)))

let hulls () =
  let hidden surfaces points =
    Option.is_some
      (Enclosure.beyond (Enclosure.of_scene (scene surfaces)) points)
  in
  let corners = [ p 0. 2. 0.; p 1. 2. 0.; p 0. 2. 1. ] in
  let plane y =
    made matte
      (Quadric (quadric (Plane { normal = Vec.v 0. 1. 0.; offset = y })))
  in
  let check name expected surfaces =
    Alcotest.(check bool) name expected (hidden surfaces corners)
  in
  check "nothing" false [];
  check "a plane before" true [ plane 1.9 ];
  check "a plane through it" false [ plane 2. ];
  check "a plane behind" false [ plane 2.1 ];
  check "in a ball" true [ ball matte (p 0. 2. 0.) 1.5 ];
  check "partly in a ball" false [ ball matte (p 0. 2. 0.) 0.9 ];
  check "outside the ball around the camera" true [ ball matte (p 0. 0. 9.) 5. ];
  check "around the ball that the camera is in" false
    [ ball matte (p 0. 2. 7.) 6.9 ]

let suite =
  ( "enclosure",
    [
      Law.example "all of smallpt's light but a cap is behind the ceiling"
        smallpt_cap;
      Law.example "walls are opaque, whole and at rest" kinds;
      Law.law ~print:show "a cap holds what is on the wall's side" case holds;
      Law.law ~print:show "the wall blocks what is left out" case blocks;
      Law.example "corners beyond a wall" hulls;
    ] )

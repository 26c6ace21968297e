(* Triangles that stand for a part of a ball. *)

open Candor_space
open Candor_surface
open Candor_oracle
open QCheck2

type case = { around : Vec.t; a : Vec.t; b : Vec.t; c : Vec.t; radius : float }

(* Three corners within half a unit of each other on the unit ball. *)
let cases =
  let near (d : Vec.t) e = Vec.add d (Vec.scale 0.25 e) in
  Gen.map
    (fun ((around, radius), (e, f, g)) ->
      {
        around;
        a = near around e;
        b = near around f;
        c = near around g;
        radius;
      })
    Gen.(
      pair
        (pair Draw.unit (Draw.wide (-20.) 20.))
        (triple Draw.unit Draw.unit Draw.unit))

let print { around; a; b; c; radius } =
  Printf.sprintf "around %s: %s, %s, %s; radius %h" (Draw.show_vec around)
    (Draw.show_vec a) (Draw.show_vec b) (Draw.show_vec c) radius

let unit d = (Dir.of_vec_or Dir.z d :> Vec.t)

(* On whatever side its corners run. *)
let triangle ?(smooth = true) { a; b; c; radius; _ } =
  let corner d =
    Point.v (radius *. (unit d).x) (radius *. (unit d).y) (radius *. (unit d).z)
  in
  let normals = if smooth then Some (unit a, unit b, unit c) else None in
  match Triangle.make ?normals { a = corner a; b = corner b; c = corner c } with
  | Ok t -> Some (Surface.triangle t ())
  | Error _ -> None

(* The hit in the middle, from outside of the ball or from inside. *)
let hit ?smooth ~from case =
  let middle = Vec.add (unit case.a) (Vec.add (unit case.b) (unit case.c)) in
  let ray =
    if from > 1. then
      Ray.v
        (Point.add Point.origin (Vec.scale (from *. case.radius) (unit middle)))
        (Vec.neg middle)
    else Ray.v Point.origin middle
  in
  Option.bind (triangle ?smooth case) (fun t -> Surface.nearest t ray)

let law name f = Law.law ~count:1000 ~print name cases f
let far (p : Point.t) = Vec.norm (Point.sub p Point.origin)

let bulges =
  law "from outside, light falls a little beyond the ball" (fun case ->
      match hit ~from:3. case with
      | None -> true
      | Some h ->
          let r = far (Hit.lit_point h) /. case.radius
          and flat = far h.point /. case.radius in
          (flat > 1. -. 0x1p-40 || Option.is_some h.lift || Law.fail "no lift")
          && ((r >= 1. -. 0x1p-40 && r -. 1. <= (1.5 *. (1. -. flat)) +. 0x1p-40)
             || Law.fail "%h from the middle, the triangle %h" r flat))

let hollow =
  law "from inside, on the triangle" (fun case ->
      match hit ~from:0. case with
      | None -> true
      | Some h ->
          Option.is_none h.lift
          && Point.equal (Hit.lit_point h) h.point
          && Ray.equal
               (Hit.spawn_lit h (h.normal :> Vec.t))
               (Hit.spawn h (h.normal :> Vec.t)))

let plain =
  law "without normals, on the triangle" (fun case ->
      match hit ~smooth:false ~from:3. case with
      | None -> true
      | Some h -> Option.is_none h.lift && Dir.equal h.normal h.shading_normal)

(* Along the surface, just above the smooth normal's horizon. *)
let grazing (h : _ Hit.t) around =
  let n = (h.shading_normal :> Vec.t) in
  let aside = unit (Vec.cross n (unit (Vec.cross n around))) in
  List.map
    (fun k -> Vec.add (Vec.scale k aside) (Vec.scale 0x1p-20 n))
    [ 1.; -1. ]

let horizon =
  law "its horizon is the ball's" (fun case ->
      match hit ~from:3. case with
      | Some h when Option.is_some h.lift ->
          List.for_all
            (fun d ->
              Hit.faces h d
              && (not (Hit.faces h (Vec.neg d)))
              && Ray.equal_departure (Hit.spawn_lit h d).departure
                   (Surface { path = h.path; part = h.part; side = h.side }))
            (grazing h case.around)
      | Some _ | None -> true)

(* From there, nothing of a mesh with its corners on the ball is in the way. *)
let clear =
  law "what it faces is clear of the ball's inside" (fun case ->
      match hit ~from:3. case with
      | Some h when Option.is_some h.lift ->
          List.for_all
            (fun d ->
              let d = unit d and o = Hit.lit_point h in
              let o = Point.sub o Point.origin in
              let t = Float.max 0. (-.Vec.dot o d) in
              let least = Vec.norm (Vec.add o (Vec.scale t d)) in
              least >= case.radius *. (1. -. 0x1p-7)
              || Law.fail "%h from the middle" (least /. case.radius))
            (grazing h case.around)
      | Some _ | None -> true)

let moved =
  law "groups take it along" (fun case ->
      match
        ( triangle case,
          Transform.of_steps
            [
              Rotate { axis = Vec.v 1. 2. 3.; degrees = 40. };
              Scale (Vec.v 2. 2. 2.);
            ] )
      with
      | None, _ | _, Error _ -> true
      | Some t, Ok m -> (
          let group = Surface.group [| Surface.seen_through ~transform:m t |] in
          let map = Affine.vector (Transform.forward m).high in
          match hit ~from:3. case with
          | None -> true
          | Some h -> (
              let lit = Point.sub (Hit.lit_point h) Point.origin in
              let eye = map (Vec.scale 3. (Point.sub h.point Point.origin)) in
              match
                Surface.nearest group
                  (Ray.v (Point.add Point.origin eye) (Vec.neg eye))
              with
              | None -> Law.fail "it is missed"
              | Some g ->
                  let found = Point.sub (Hit.lit_point g) Point.origin in
                  Vec.norm (Vec.sub found (map lit))
                  <= 0x1p-30 *. Vec.norm found
                  || Law.fail "elsewhere")))

let suite =
  ("bulging triangles", [ bulges; hollow; plain; horizon; clear; moved ])

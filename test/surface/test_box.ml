open Candor_space
open Candor_surface
open Candor_oracle
open Candor_surface_families

let p = Point.v
let v = Vec.v
let unit = Made.box Point.origin (p 1. 1. 1.)

let meets name b ray expected () =
  match (Boxes.kind.answer b ray, expected) with
  | None, None -> ()
  | Some a, Some (t, side, part) when a.t = t && a.side = side && a.part = part
    ->
      ()
  | found, expected ->
      Alcotest.failf "%s: expected %s, found %s" name
        (Family.show_answer
           (Option.map
              (fun (t, side, part) -> { Crossing.t; side; part })
              expected))
        (Family.show_answer found)

let rows =
  let out t part = Some (t, Side.Outside, part)
  and within t part = Some (t, Side.Inside, part) in
  [
    ( "B1: along a face, in its plane",
      unit,
      Ray.v (p 0. 0.5 (-1.)) (v 0. 0. 1.),
      out 1. 4 );
    ( "B2: the same with a zero of the other sign",
      unit,
      Ray.v (p 1. 0.5 (-1.)) (v (-0.) 0. 1.),
      out 1. 4 );
    ( "B3: along an upper face",
      unit,
      Ray.v (p 0.5 0. (-1.)) (v 0. (-0.) 1.),
      out 1. 4 );
    ("B3: along an edge", unit, Ray.v (p (-1.) 0. 0.) (v 1. 0. 0.), out 1. 0);
    ( "B3: just beside an edge",
      unit,
      Ray.v (p (-1.) (-5e-324) 0.) (v 1. 0. 0.),
      None );
    ( "B5: a flat box, across",
      Made.box (p 0. 0. 2.) (p 1. 1. 2.),
      Ray.v (p 0.5 0.5 0.) (v 0. 0. 1.),
      out 2. 4 );
    ( "B5: a flat box, from above",
      Made.box (p 0. 0. 2.) (p 1. 1. 2.),
      Ray.v (p 0.5 0.5 5.) (v 0. 0. (-1.)),
      out 3. 5 );
    ( "B7: a subnormal direction",
      unit,
      Ray.v (p 0.5 (-1.) 0.5) (v 1e-310 1. 0.),
      out 1. 2 );
    ( "B7: the least direction",
      unit,
      Ray.v (p 0.5 (-1.) 0.5) (v 5e-324 1. 0.),
      out 1. 2 );
    ( "B7: only the least direction",
      unit,
      Ray.v (p (-1e-320) 0.5 0.5) (v 5e-324 0. 0.),
      out 2024. 0 );
    ( "B7: a t beyond the doubles",
      unit,
      Ray.v (p (-1.) 0.5 0.5) (v 5e-324 0. 0.),
      None );
    ("B9: from inside", unit, Ray.v (p 0.5 0.5 0.25) (v 0. 0. 1.), within 0.75 5);
    ( "B9: from the face, inwards",
      unit,
      Ray.v (p 0. 0.5 0.5) (v 1. 0. 0.),
      within 1. 1 );
    ( "B9: from the face, outwards",
      unit,
      Ray.v (p 0. 0.5 0.5) (v (-1.) 0. 0.),
      None );
    ( "B9: one ulp outside, away",
      unit,
      Ray.v (p (Float.succ 1.) 0.5 0.5) (v 1. 0. 0.),
      None );
    ("B9: behind", unit, Ray.v (p 0.5 0.5 2.) (v 0. 0. 1.), None);
    ( "B10: at an edge the lower axis wins",
      unit,
      Ray.v (p (-1.) (-1.) 0.5) (v 1. 1. 0.),
      out 1. 0 );
    ( "B10: at a corner the lowest axis wins",
      unit,
      Ray.v (p 2. 2. 2.) (v (-1.) (-1.) (-1.)),
      out 1. 1 );
    ( "B10: out through an edge the lower axis wins",
      unit,
      Ray.v (p 0.5 0.5 0.5) (v 0. (-1.) (-1.)),
      within 0.5 2 );
  ]

let b8 () =
  List.iter
    (fun k ->
      let d = v 1. 2. 3. in
      let t d =
        Option.map
          (fun (a : Crossing.answer) -> a.t)
          (Boxes.kind.answer unit (Ray.v (p (-1.) (-2.) (-3.)) d))
      in
      let scaled = t (Vec.scale (Float.ldexp 1. k) d) in
      Alcotest.(check (option (float 0.)))
        (Printf.sprintf "2^%d" k)
        (Option.map (fun t -> Float.ldexp t (-k)) (t d))
        scaled)
    [ -66; -200; -900; 66; 200; 900 ]

let rejected =
  let reject name low high =
    Law.example (name ^ " is rejected") (fun () ->
        match Box.make ~min:low ~max:high with
        | Error why when why <> "" -> ()
        | _ -> Alcotest.failf "%s is accepted" name)
  in
  [
    reject "B6: min above max" (p 0. 1. 0.) (p 1. 0. 1.);
    reject "B6: a nan corner" (p 0. nan 0.) (p 1. 1. 1.);
    reject "B6: an infinite corner" (p 0. 0. 0.) (p infinity 1. 1.);
    reject "a box flat on two axes" (p 0. 0. 0.) (p 1. 0. 0.);
    reject "a box that is a point" (p 1. 1. 1.) (p 1. 1. 1.);
    reject "a corner beyond 2^400" (p 0. 0. 0.) (p 1. 0x1.8p400 1.);
  ]

(* {1 Substitution} *)

let found { Family.shape; ray } f =
  match Surface.nearest (Surface.box shape ()) ray with
  | None -> true
  | Some h -> f (shape :> Bounds.t) h

let in_face (b : Bounds.t) (h : unit Hit.t) =
  let q = h.point in
  let face =
    [|
      (q.x, b.x0);
      (q.x, b.x1);
      (q.y, b.y0);
      (q.y, b.y1);
      (q.z, b.z0);
      (q.z, b.z1);
    |]
  in
  let on, face = face.(h.part) in
  on = face && Bounds.mem q b

let axis_normal _ (h : unit Hit.t) =
  let out =
    [|
      v (-1.) 0. 0.;
      v 1. 0. 0.;
      v 0. (-1.) 0.;
      v 0. 1. 0.;
      v 0. 0. (-1.);
      v 0. 0. 1.;
    |].(h.part)
  in
  Vec.equal (h.local.normal :> Vec.t) out

let uv (b : Bounds.t) (h : unit Hit.t) =
  let q = h.point in
  let across x lo hi = if hi > lo then (x -. lo) /. (hi -. lo) else 0. in
  let x = across q.x b.x0 b.x1
  and y = across q.y b.y0 b.y1
  and z = across q.z b.z0 b.z1 in
  let expected =
    match h.part / 2 with 0 -> (y, z) | 1 -> (x, z) | _ -> (x, y)
  in
  match Lazy.force h.uv with
  | Some ((u, v) as found) ->
      found = expected && u >= 0. && u <= 1. && v >= 0. && v <= 1.
  | None -> false

let faces_ray { Family.shape; ray } =
  match Surface.nearest (Surface.box shape ()) ray with
  | None -> true
  | Some h -> Vec.dot (h.normal :> Vec.t) ray.direction < 0.

let law name holds =
  Law.law ~count:5000 ~print:(Family.show Boxes.kind) name Boxes.aimed.cases
    holds

let suite =
  ( "box",
    List.concat
      [
        List.map
          (fun (name, b, ray, expected) ->
            Law.example name (meets name b ray expected))
          rows;
        [
          Law.example
            "B8: short and long directions give t as much longer and shorter" b8;
          law "points are in the face, exactly" (fun c -> found c in_face);
          law "the normal is that of the face" (fun c -> found c axis_normal);
          law "the normal faces the ray" faces_ray;
          law "uv runs over the face" (fun c -> found c uv);
        ];
        rejected;
      ] )

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
  match Lazy.force h.local.uv with
  | Some ((u, v) as found) ->
      found = expected && u >= 0. && u <= 1. && v >= 0. && v <= 1.
  | None -> false

let faces_ray { Family.shape; ray } =
  match Surface.nearest (Surface.box shape ()) ray with
  | None -> true
  | Some h -> Vec.dot (h.normal :> Vec.t) ray.direction < 0.

(* {1 Leaving an edge}

   Inwards from one face and out of another that is met there. *)

type leaving = { box : Box.t; at : Point.t; part : int; toward : Vec.t }

let show_leaving { box; at; part; toward } =
  Printf.sprintf "%s\nfrom %s, face %d, along %s" (Boxes.show box)
    (Draw.show_point at) part (Draw.show_vec toward)

(* Where a coordinate is, and which way the ray goes along it. *)
type place = { x : float; d : float; end_ : int option }

let leaving =
  let open QCheck2.Gen in
  let speed = oneof [ return 1.; Draw.wide (-9.) 9. ] in
  let on_end (lo, hi) ~out =
    let* high = bool and* d = speed in
    let outward = if high then d else -.d in
    return
      {
        x = (if high then hi else lo);
        d = (if out then outward else -.outward);
        end_ = Some (if high then 1 else 0);
      }
  and between (lo, hi) =
    let* k = Draw.uniform 0.25 0.75 and* d = Draw.signed speed in
    return { x = lo +. (k *. (hi -. lo)); d; end_ = None }
  in
  let corner =
    oneof [ Draw.point (Draw.small 4); Draw.point (Draw.uniform (-9.) 9.) ]
  in
  let* box = map2 (Boxes.between ~flat:3) corner corner in
  let b = (box :> Bounds.t) in
  let ends = [| (b.x0, b.x1); (b.y0, b.y1); (b.z0, b.z1) |] in
  let* face = int_bound 2 and* next = int_range 1 2 in
  let out = (face + next) mod 3 in
  let* from = on_end ends.(face) ~out:false
  and* into = on_end ends.(out) ~out:true
  and* third =
    let slab = ends.(3 - face - out) in
    oneof [ between slab; on_end slab ~out:true; on_end slab ~out:false ]
  in
  let on i = if i = face then from else if i = out then into else third in
  return
    {
      box;
      at = p (on 0).x (on 1).x (on 2).x;
      part = (2 * face) + Option.value from.end_ ~default:0;
      toward = v (on 0).d (on 1).d (on 2).d;
    }

(* The first of the faces that the ray leaves at its start. *)
let face_ahead { box; at; toward; _ } =
  let b = (box :> Bounds.t) in
  let leaves i lo hi =
    let x = Point.get at i and d = Vec.get toward i in
    if d < 0. && x = lo then Some (2 * i)
    else if d > 0. && x = hi then Some ((2 * i) + 1)
    else None
  in
  List.find_map Fun.id
    [ leaves 0 b.x0 b.x1; leaves 1 b.y0 b.y1; leaves 2 b.z0 b.z1 ]

let start { box; at; part; toward } =
  ( Surface.box box (),
    Ray.leaving (Surface { path = [ 0 ]; part; side = Inside }) at toward )

let meets_at_once l =
  let s, ray = start l in
  Surface.blocked s ~limit:infinity ray
  &&
  match Surface.nearest s ray with
  | None -> Law.fail "it leaves the box unseen"
  | Some h ->
      let b = (l.box :> Bounds.t) in
      let extent = Vec.largest (Point.sub (Bounds.high b) (Bounds.low b)) in
      Some h.part = face_ahead l
      && h.side = Inside && h.t > 0.
      && h.t *. Vec.largest l.toward <= 0x1p-52 *. extent
      && Vec.largest (Point.sub h.point l.at) <= 0x1p-52 *. extent

let at_once_at_any_size (l, k) =
  let c = Shapes.scaling k in
  match Shapes.change c (Box l.box) with
  | Some (Box box) ->
      let t l =
        let s, ray = start l in
        Option.map (fun (h : _ Hit.t) -> h.t) (Surface.nearest s ray)
      in
      t { l with box; at = c.point l.at }
      = Option.map (fun t -> t *. c.length) (t l)
  | Some (Sphere _ | Triangle _ | Quadric _) | None -> false

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
          Law.law ~count:5000 ~print:show_leaving
            "a ray from an edge, inwards from one face and out of another, \
             meets that one at once"
            leaving meets_at_once;
          Law.law
            ~print:(fun (l, k) ->
              Printf.sprintf "%s\nk = %d" (show_leaving l) k)
            "at once is 2^k as long in a box 2^k as large"
            QCheck2.Gen.(pair leaving (int_range (-60) 60))
            at_once_at_any_size;
        ];
        rejected;
      ] )

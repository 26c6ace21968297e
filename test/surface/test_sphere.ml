open Candor_space
open Candor_surface
open Candor_oracle
open Candor_surface_families

let p = Point.v
let v = Vec.v
let at_origin = Made.sphere Point.origin

let meets name s ray expected () =
  let t =
    Option.map (fun (a : Crossing.answer) -> a.t) (Spheres.kind.answer s ray)
  in
  match (t, expected) with
  | Some t, Some x when Exact.within 4. t (Exact.q x) -> ()
  | _ -> Alcotest.(check (option (float 0.))) name expected t

(* The rows of the catalogue of hard cases. *)
let rows =
  let unit = at_origin 1. in
  let z = v 0. 0. 1. and x = v 1. 0. 0. in
  [
    ("S1: from 1e9 away", unit, Ray.v (p 0. 0. (-1e9)) z, Some 999999999.);
    ("S2: just past it", unit, Ray.v (p (-1e8) (1. +. 1e-9) 0.) x, None);
    ( "S3: through its edge",
      unit,
      Ray.v (p (-1e8) 0.999999 0.) x,
      Some 99999999.99858579 );
    ("S4: an exact tangent", unit, Ray.v (p (-5.) 1. 0.) x, Some 5.);
    ( "S4: an exact tangent aslant",
      at_origin 5.,
      Ray.v (p (-7.) 1. 0.) (v 4. 3. 0.),
      Some 1. );
    ("S5: a tiny one", at_origin 1e-8, Ray.v (p 0. 0. (-1.)) z, Some 0.99999999);
    ("S6: past a tiny one", at_origin 1e-9, Ray.v (p 0. 2e-9 (-1.)) z, None);
    ( "S7: from inside a huge one",
      at_origin 1e15,
      Ray.v (p 0. 0. (1e15 -. 1.)) z,
      Some 1. );
    ( "S11: a short direction",
      unit,
      Ray.v (p 0. 0. (-5.)) (v 0. 0. 1e-160),
      Some 4e160 );
    ( "S12: a shorter direction",
      unit,
      Ray.v (p 0. 0. (-5.)) (v 0. 0. 1e-170),
      Some 4e170 );
    ( "S12: a long direction",
      unit,
      Ray.v (p 0. 0. (-5.)) (v 0. 0. 1e160),
      Some 4e-160 );
    ( "S14: from on it, inwards",
      unit,
      Ray.v (p 0. 0. 1.) (v 0. 0. (-1.)),
      Some 2. );
    ("S14: from on it, outwards", unit, Ray.v (p 0. 0. 1.) z, None);
    ("S14: from on it, along it", unit, Ray.v (p 0. 0. 1.) x, None);
  ]

let s8 () =
  (* From the wall's inner side: t = 9.9999999991773e-7. *)
  let s = Made.sphere (p (1e5 +. 1.) 40.8 81.6) 1e5 in
  let ray = Ray.v (p (1. +. 1e-6) 40.8 81.6) (v (-1.) 0. 0.) in
  match Spheres.kind.answer s ray with
  | Some { t; _ } when Float.abs (t -. 9.9999999991773e-7) < 1e-20 -> ()
  | other -> Alcotest.fail (Family.show_answer other)

let s13 () =
  let huge = 0x1p400 in
  let s = Made.sphere (p 0. 0. (huge /. 2.)) (huge /. 8.) in
  meets "2^400" s (Ray.v Point.origin (v 0. 0. 1.)) (Some (huge *. 0.375)) ();
  let tiny = 0x1p-400 in
  let s = Made.sphere (p 0. 0. (tiny *. 5.)) tiny in
  meets "2^-400" s (Ray.v Point.origin (v 0. 0. 1.)) (Some (tiny *. 4.)) ()

let s20 () =
  List.iter
    (fun gap ->
      let outer = Made.sphere Point.origin (1. +. gap)
      and inner = Made.sphere Point.origin 1. in
      let both =
        Surface.group [| Surface.sphere inner 1; Surface.sphere outer 0 |]
      in
      let rec through ray = function
        | [] -> Surface.nearest both ray = None
        | (surface, side) :: rest -> (
            match Surface.nearest both ray with
            | Some h ->
                h.material = surface && h.side = side
                && through (Hit.spawn h ray.direction) rest
            | None -> false)
      in
      Alcotest.(check bool)
        (Printf.sprintf "gap %g" gap)
        true
        (through
           (Ray.v (p (-3.) 0.1 0.2) (v 1. 0. 0.))
           [ (0, Outside); (1, Outside); (1, Inside); (0, Inside) ]))
    [ 4e-5; 1e-9; 1e-13 ]

let rejects name ~center ~radius () =
  match Sphere.make ~center ~radius with
  | Error why when why <> "" -> ()
  | _ -> Alcotest.failf "%s is accepted" name

let constructors =
  List.concat
    [
      List.map
        (fun radius ->
          let name = Printf.sprintf "S16: a radius of %h is rejected" radius in
          Law.example name (rejects name ~center:Point.origin ~radius))
        [ 0.; -0.; -1.; nan; infinity; 0x1p-401; 0x1.8p400; -1e300; 5e-324 ];
      List.map
        (fun x ->
          let name = Printf.sprintf "a centre at %h is rejected" x in
          Law.example name (rejects name ~center:(p 0. x 0.) ~radius:1.))
        [ nan; infinity; neg_infinity; 0x1.8p400; -1e300 ];
    ]

(* {1 Substitution} *)

let found { Family.shape; ray } f =
  match Surface.nearest (Surface.sphere shape ()) ray with
  | None -> true
  | Some h -> f shape h

(* |p - c| is r within the error of the hit. *)
let on_sphere (s : Sphere.t) (h : unit Hit.t) =
  let value = Exact_sphere.value s (Exact.point h.point) in
  let r = Exact.q s.radius in
  let e = Exact.vec h.local.error in
  let reach = Exact.size e in
  Q.leq (Q.abs value) Exact.(reach * ((two * r) + reach))

(* Up to rounding: the point is not made from the normal. *)
let radial (s : Sphere.t) (h : unit Hit.t) =
  let c = Sphere.center s in
  let q = Point.along c (h.local.normal :> Vec.t) s.radius in
  let size = Vec.largest (Point.sub c Point.origin) +. s.radius in
  Vec.largest (Point.sub q h.point) <= 0x1p-50 *. size

let uv_of_normal _ (h : unit Hit.t) =
  let n = (h.local.normal :> Vec.t) in
  match Lazy.force h.local.uv with
  | None -> false
  | Some (u, v) ->
      (* Near the poles the arcsine knows half of the digits. *)
      let close a b = Float.abs (a -. b) <= 0x1p-25 in
      u >= 0. && u <= 1. && v >= 0. && v <= 1.
      && close (sin (Float.pi *. (v -. 0.5))) n.y
      &&
      let c = cos (Float.pi *. (v -. 0.5)) in
      close (c *. sin (2. *. Float.pi *. (u -. 0.5))) n.x
      && close (c *. cos (2. *. Float.pi *. (u -. 0.5))) n.z

let in_bounds s (h : unit Hit.t) =
  Bounds.mem h.point (Bounds.widen 0. (Sphere.bounds s))

let anything name f =
  Law.law ~count:5000 ~print:(Family.show Spheres.kind) name
    Spheres.anything.cases (fun c -> found c f)

let suite =
  ( "sphere",
    List.concat
      [
        List.map
          (fun (name, s, ray, expected) ->
            Law.example name (meets name s ray expected))
          rows;
        [
          Law.example "S8: smallpt's wall from 1e-6 away" s8;
          Law.example "S13: scenes at 2^400 and 2^-400" s13;
          Law.example "S20: gaps of 4e-5, 1e-9, 1e-13 are seen" s20;
          anything "points are on the sphere within their error" on_sphere;
          anything "points are where the normal says" radial;
          anything "uv are the angles of the normal" uv_of_normal;
          anything "points are within the bounds" in_bounds;
        ];
        constructors;
      ] )

(** Families for quadrics: K1 to K8 of the numerical notes, and the cut ones. *)

open Candor_space
open Candor_surface
open Candor_oracle
open QCheck2.Gen
open Draw
open Made

let show_numbers a =
  String.concat " " (List.map (Printf.sprintf "%h") (Array.to_list a))

let show_shape : Quadric_shape.t -> string =
  let axial name a b r =
    Printf.sprintf "%s %s %s %h" name (show_point a) (show_point b) r
  and centred name c r =
    Printf.sprintf "%s at %s with %s" name (show_point c) (show_vec r)
  in
  function
  | Matrix q -> "matrix " ^ show_numbers q
  | Form { a; b; c } ->
      Printf.sprintf "form a %s b %s c %h" (show_numbers a) (show_vec b) c
  | Plane { normal; offset } ->
      Printf.sprintf "plane %s %h" (show_vec normal) offset
  | Ellipsoid { center; radii } -> centred "ellipsoid" center radii
  | Cylinder { from; until; radius } -> axial "cylinder" from until radius
  | Cone { apex; base; radius } -> axial "cone" apex base radius
  | Paraboloid { apex; base; radius } -> axial "paraboloid" apex base radius
  | Hyperbolic_paraboloid { center; radii } ->
      centred "hyperbolic paraboloid" center radii
  | Hyperboloid_one_sheet { center; radii } ->
      centred "hyperboloid of one sheet" center radii
  | Hyperboloid_two_sheets { center; radii } ->
      centred "hyperboloid of two sheets" center radii

let show q =
  show_shape (Quadric.shape q)
  ^ (match Quadric.clip q with
    | None -> ""
    | Some b ->
        Printf.sprintf " clipped to %s %s"
          (show_point (Bounds.low b))
          (show_point (Bounds.high b)))
  ^ if Quadric.caps q then " with caps" else ""

let kind =
  {
    Family.show;
    answer = (fun q -> answer (Surface.quadric q ()));
    truth = (fun q -> Exact_quadric.(truth_along (of_quadric q)));
  }

let family name cases = { Family.name; cases }
let case shape ray = { Family.shape; ray }

(* {1 The plain ones} *)

(* xx yy zz, then twice half the linear z, then the constant. *)
let form ?(xy = 0.) ?(xz = 0.) ?(yz = 0.) x y z (b : Vec.t) c : Quadric_shape.t
    =
  Form { a = [| x; xy; xz; xy; y; yz; xz; yz; z |]; b; c }

let ellipsoid = form 1. 4. 0.25 Vec.zero (-1.)
let cone = form 1. 1. (-1.) Vec.zero 0.
let paraboloid = form 1. 1. 0. (v 0. 0. 0.5) 0.
let hyperboloid = form 1. 1. (-1.) Vec.zero (-1.)
let cylinder = form 1. 1. 0. Vec.zero (-1.)

let aimed far =
  let* d = unit and* far = wide 0.3 far in
  let o = move Point.origin d far in
  let* target = point (uniform (-1.2) 1.2) in
  return (Ray.v o (normalised (toward o target)))

let k1 =
  family "K1 an ellipsoid from up to 1e6 away"
    (map (case (quadric ellipsoid)) (aimed 6.))

let k2 =
  family "K2 a cone from up to 1e6 away" (map (case (quadric cone)) (aimed 6.))

let near_generator shape =
  let* turn = uniform 0. 6.283 and* e = wide (-16.) (-1.) and* a = unit in
  let d = Vec.add (v (cos turn) (sin turn) 1.) (Vec.scale e a) in
  let* n = unit and* far = wide 0. 3. in
  return (case (quadric shape) (Ray.v (move Point.origin n far) d))

let k3 = family "K3 a cone along its generators" (near_generator cone)

let k4 =
  family "K4 a paraboloid along its axis"
    (let* s = sign and* e = wide (-16.) (-1.) and* a = unit in
     let d = Vec.add (v 0. 0. s) (Vec.scale e a) in
     let* n = unit and* far = wide 0. 3. in
     return (case (quadric paraboloid) (Ray.v (move Point.origin n far) d)))

let k5 =
  family "K5 a hyperboloid along its generators" (near_generator hyperboloid)

let k6 =
  family "K6 a cylinder along its axis"
    (let* s = sign and* e = wide (-16.) (-1.) and* a = unit in
     let d = Vec.add (v 0. 0. s) (Vec.scale e a) in
     let* x = uniform (-2.) 2. and* y = uniform (-2.) 2. in
     let* z = signed (wide 0. 4.) in
     return (case (quadric cylinder) (Ray.v (p x y z) d)))

(* Rᵀ Q R for a random rotation, rounded. *)
let rotated (shape : Quadric_shape.t) : Quadric_shape.t t =
  match shape with
  | Form { a; b; c } ->
      let* w = unit in
      let* u = across w in
      let v' = Vec.cross w u in
      let r = [| u; v'; w |] in
      let entry i j =
        let sum = ref 0. in
        for k = 0 to 2 do
          for l = 0 to 2 do
            sum :=
              !sum +. (Vec.get r.(k) i *. a.((3 * k) + l) *. Vec.get r.(l) j)
          done
        done;
        !sum
      in
      let xy = entry 0 1 and xz = entry 0 2 and yz = entry 1 2 in
      let turn i =
        (b.x *. Vec.get u i) +. (b.y *. Vec.get v' i) +. (b.z *. Vec.get w i)
      in
      return
        (form ~xy ~xz ~yz (entry 0 0) (entry 1 1) (entry 2 2)
           (v (turn 0) (turn 1) (turn 2))
           c)
  | other -> return other

(* Where no quadric results, the unit cylinder. *)
let some shape =
  match Quadric.make shape with Ok q -> q | Error _ -> quadric cylinder

let k7 =
  family "K7 any of five, turned at random, from up to 1e6 away"
    (let* shape = pick [ ellipsoid; cone; paraboloid; hyperboloid; cylinder ] in
     let* shape = rotated shape and* ray = aimed 6. in
     return (case (some shape) ray))

let k8 =
  family "K8 grazing an ellipsoid within 1e-3..1e-14"
    (let* n = unit in
     let at = v n.x (n.y *. 0.5) (n.z *. 2.) in
     let slope = v at.x (4. *. at.y) (0.25 *. at.z) in
     let* along = across slope and* s = sign and* e = wide (-14.) (-3.) in
     let* far = wide 0. 3. in
     let p = move (Point.add Point.origin at) (normalised slope) (s *. e) in
     return (case (quadric ellipsoid) (Ray.v (move p along (-.far)) along)))

let whole =
  family "whole numbers: rulings, apexes, double planes, exact tangents"
    (let n = small 2 in
     let* x = n and* y = n and* z = n and* xy = n and* xz = n in
     let* mixed = int_bound 2 in
     let xy, xz = if mixed = 0 then (xy, xz) else (0., 0.) in
     let* b = oneof [ return Vec.zero; vec n ] and* c = n in
     let* o = point (small 6) and* d = vec (small 3) in
     let d = if Vec.largest d = 0. then v 0. 0. 1. else d in
     let* k = either 70 (return 0) (int_range (-40) 40) in
     let d = Vec.scale (Float.ldexp 1. k) d in
     return (case (some (form ~xy ~xz x y z b c)) (Ray.v o d)))

let random =
  family "random matrices"
    (let* x = coordinate and* y = coordinate and* z = coordinate in
     let* xy = coordinate and* xz = coordinate and* yz = coordinate in
     let* b = vec coordinate and* c = coordinate in
     let* ray = point coordinate >>= ray_at in
     return (case (some (form ~xy ~xz ~yz x y z b c)) ray))

(* {1 The named ones} *)

let radii =
  vec (oneof [ map (fun x -> 1. +. Float.abs x) (small 3); wide (-2.) 2. ])

let place = point (oneof [ small 4; uniform (-9.) 9. ])

let named : Quadric_shape.t t =
  let between f =
    let* a = place and* n = oneof [ Draw.axial; unit ] and* l = wide (-1.) 1. in
    let* r = oneof [ return 1.; wide (-2.) 2. ] in
    return (f a (move a n l) r)
  and centred f =
    let* c = place and* r = radii in
    return (f c r)
  in
  oneof
    [
      (let* normal = oneof [ Draw.axial >>= stretched; unit; vec (small 4) ] in
       let normal = if Vec.largest normal = 0. then v 0. 1. 0. else normal in
       let* offset = oneof [ small 4; uniform (-9.) 9. ] in
       return (Quadric_shape.Plane { normal; offset }));
      centred (fun center radii -> Quadric_shape.Ellipsoid { center; radii });
      between (fun from until radius ->
          Quadric_shape.Cylinder { from; until; radius });
      between (fun apex base radius ->
          Quadric_shape.Cone { apex; base; radius });
      between (fun apex base radius ->
          Quadric_shape.Paraboloid { apex; base; radius });
      centred (fun center radii ->
          Quadric_shape.Hyperbolic_paraboloid { center; radii });
      centred (fun center radii ->
          Quadric_shape.Hyperboloid_one_sheet { center; radii });
      centred (fun center radii ->
          Quadric_shape.Hyperboloid_two_sheets { center; radii });
    ]

let ends : Quadric_shape.t -> (Point.t * Point.t * float) option = function
  | Cylinder { from; until; radius } -> Some (from, until, radius)
  | Cone { apex; base; radius } | Paraboloid { apex; base; radius } ->
      Some (apex, base, radius)
  | _ -> None

(* Points worth aiming at: the rims and the middles of the ends, the middle. *)
let landmark shape =
  match (ends shape, shape) with
  | Some (a, b, r), _ ->
      let* across = across (toward a b) in
      let* k = oneof [ return 1.; uniform 0. 1.2; return 0. ] in
      let* t = oneof [ return 0.; return 1.; uniform (-0.1) 1.1 ] in
      return (move (move a (toward a b) t) across (k *. r))
  | ( None,
      ( Ellipsoid { center; radii }
      | Hyperbolic_paraboloid { center; radii }
      | Hyperboloid_one_sheet { center; radii }
      | Hyperboloid_two_sheets { center; radii } ) ) ->
      let* n = vec (uniform (-1.5) 1.5) in
      return
        (Point.add center
           (v (n.x *. radii.x) (n.y *. radii.y) (n.z *. radii.z)))
  | None, _ -> point (uniform (-3.) 3.)

let simply =
  family "named shapes, uncapped and unclipped"
    (let* shape = named in
     let* target = landmark shape in
     let* ray = ray_at target in
     return (case (quadric shape) ray))

let from lo hi =
  family
    (Printf.sprintf "named shapes, from 1e%g..1e%g away" lo hi)
    (let* shape = named in
     let* target = landmark shape and* n = unit and* far = wide lo hi in
     let o = move target n far in
     return (case (quadric shape) (Ray.v o (normalised (toward o target)))))

let from_far = from 3. 12.
let from_beyond = from 12. 18.

let capped =
  family "cylinders, cones and paraboloids with caps, aimed at their rims"
    (let* shape = named in
     match ends shape with
     | None ->
         map (fun ray -> case (quadric shape) ray) (landmark shape >>= ray_at)
     | Some _ ->
         let* target = landmark shape in
         let* ray = ray_at target in
         return (case (quadric ~caps:true shape) ray))

(* Clip planes through the target, so that roots fall upon them. *)
let clipped =
  family "clipped through the very point aimed at"
    (let* shape = named in
     let* target = landmark shape and* other = landmark shape in
     let* k = int_bound 7 in
     let lo bit a b =
       if k land bit = 0 then Float.min a b else Float.max a b -. 1.
     in
     let* size = wide (-1.) 1. in
     let low =
       p (lo 1 target.x other.x) (lo 2 target.y other.y) (lo 4 target.z other.z)
     in
     let high =
       p
         (Float.max low.x (Float.max target.x other.x)
         +. if k land 1 = 0 then size else 0.)
         (Float.max low.y (Float.max target.y other.y)
         +. if k land 2 = 0 then size else 0.)
         (Float.max low.z (Float.max target.z other.z)
         +. if k land 4 = 0 then size else 0.)
     in
     let* caps = bool in
     let caps = caps && ends shape <> None in
     let* ray = ray_at target in
     return (case (quadric ~clip:(Bounds.v low high) ~caps shape) ray))

let whole_clips =
  family "whole numbers, clipped and capped: exact ties at rims"
    (let* a = point (small 3) and* axis = Draw.axial in
     let* l = map (fun x -> 1. +. Float.abs x) (small 3) in
     let* r = pick [ 5.; 1.; 2.; 3. ] in
     let b = move a axis l in
     let* shape =
       pick
         [
           Quadric_shape.Cylinder { from = a; until = b; radius = r };
           Cone { apex = a; base = b; radius = r };
           Paraboloid { apex = a; base = b; radius = r };
         ]
     in
     let* caps = bool in
     let* clip =
       oneof
         [
           return None;
           (let* c = point (small 5) and* e = vec (map Float.abs (small 6)) in
            return (Some (Bounds.v c (Point.add c e))));
         ]
     in
     let* o = point (small 8) and* target = point (small 5) in
     let d = toward o target in
     let d = if Vec.largest d = 0. then v 1. 0. 0. else d in
     return (case (quadric ?clip ~caps shape) (Ray.v o d)))

let thin =
  family "an ellipsoid of 1 x 1e-6 x 1e3"
    (let* x = uniform (-1.) 1.
     and* y = uniform (-1e-6) 1e-6
     and* z = uniform (-1e3) 1e3 in
     let* n = unit and* far = wide 3. 5. in
     let o = move Point.origin n far in
     return
       (case
          (quadric (Ellipsoid { center = Point.origin; radii = v 1. 1e-6 1e3 }))
          (Ray.v o (normalised (toward o (p x y z))))))

let touching =
  family "named shapes, from a rounded point on them"
    (let* shape = named in
     let* target = landmark shape in
     let* ray = ray_at target in
     let q = quadric shape in
     let* d = unit in
     match Surface.nearest (Surface.quadric q ()) ray with
     | Some h -> return (case q (Ray.v h.point d))
     | None -> return (case q ray))

let all =
  [
    k1;
    k2;
    k3;
    k4;
    k5;
    k6;
    k7;
    k8;
    whole;
    random;
    simply;
    from_far;
    from_beyond;
    capped;
    clipped;
    whole_clips;
    thin;
    touching;
  ]

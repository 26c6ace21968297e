open Candor_space
open Candor_surface
open Candor_sample
open Candor_scene

type ball = { center : Point.t; radius : float; both : bool }

type cap = {
  apex : Point.t;
  frame : Frame.t; (* its third axis goes through the apex *)
  radius : float; (* of the sphere *)
  one_minus_cos : float;
}

(* Corners run counter-clockwise as seen from where [normal] points. *)
type facet = { a : Point.t; b : Point.t; c : Point.t; normal : Vec.t }

type visible =
  | Facing (* facets are seen from where their normals point *)
  | All (* from both sides *)
  | Hull (* facing; and from inside, where none faces, everything is *)

type t =
  | Ball of ball
  | Ellipsoid of Ellipsoid_target.t
  | Cap of cap
  | Facets of { visible : visible; facets : facet list }

type sample = Ellipsoid_target.sample = { direction : Dir.t; density : float }

let full = 4. *. Float.pi

(* {1 Making} *)

let facet (a, b, c) =
  let normal (n : Dir.t) = { a; b; c; normal = (n :> Vec.t) } in
  Option.map normal (Dir.of_vec (Vec.cross (Point.sub b a) (Point.sub c a)))

let facets visible corners =
  Facets { visible; facets = List.filter_map facet corners }

let placed (p : Primitives.t) at =
  match p.transform with
  | None -> at
  | Some m -> fst (Wide_affine.point (Transform.forward m) at Vec.zero)

(* By how much a map stretches everything, where it does so evenly. *)
let stretch m =
  let { Affine.x; y; z; _ } = Affine.columns m in
  let lx = Vec.norm x and ly = Vec.norm y and lz = Vec.norm z in
  let even l = Float.abs (l -. lx) <= 0x1p-45 *. lx
  and across a b l = Float.abs (Vec.dot a b) <= 0x1p-45 *. l in
  if
    even ly && even lz
    && across x y (lx *. ly)
    && across y z (ly *. lz)
    && across z x (lz *. lx)
  then Some (Float.max lx (Float.max ly lz))
  else None

let similarity (p : Primitives.t) =
  match p.transform with
  | None -> Some 1.
  | Some m -> stretch (Transform.forward m).high

(* Does the map turn left hands into right ones? *)
let mirrors (p : Primitives.t) =
  match p.transform with
  | None -> false
  | Some m ->
      let { Affine.x; y; z; _ } = Affine.columns (Transform.forward m).high in
      let unit a = (Dir.of_vec_or Dir.z a :> Vec.t) in
      Vec.dot (Vec.cross (unit x) (unit y)) (unit z) < 0.

(* The corner of [b] at its high end along the axes whose bits are set. *)
let corner p (b : Bounds.t) i =
  let high bit = i land bit <> 0 in
  placed p
    (Point.v
       (if high 1 then b.x1 else b.x0)
       (if high 2 then b.y1 else b.y0)
       (if high 4 then b.z1 else b.z0))

(* Outwards, as the corners are numbered: the low and the high face of each
   axis. *)
let quads =
  [
    (0, 4, 6, 2);
    (1, 3, 7, 5);
    (0, 1, 5, 4);
    (2, 6, 7, 3);
    (0, 2, 3, 1);
    (4, 5, 7, 6);
  ]

let flat_along (b : Bounds.t) =
  if b.x0 = b.x1 then Some 1
  else if b.y0 = b.y1 then Some 3
  else if b.z0 = b.z1 then Some 5
  else None

let halves flip (i, j, k, l) =
  if flip then [ (i, k, j); (i, l, k) ] else [ (i, j, k); (i, k, l) ]

let box p visible (b : Bounds.t) =
  let flip = mirrors p in
  let at (i, j, k) = (corner p b i, corner p b j, corner p b k) in
  let made quads = List.map at (List.concat_map (halves flip) quads) in
  if not (Bounds.is_finite b) then facets Facing []
  else
    match flat_along b with
    | None -> facets visible (made quads)
    | Some high -> facets All (made [ List.nth quads high ])

let ellipsoid (p : Primitives.t) center radii =
  let m =
    match p.transform with
    | None -> Affine.identity
    | Some m -> (Transform.forward m).high
  in
  let center = placed p center in
  Ellipsoid (Ellipsoid_target.make m ~center ~radii ~both:p.both_sides)

let sphere (p : Primitives.t) s =
  match similarity p with
  | Some k ->
      Ball
        {
          center = placed p (Sphere.center s);
          radius = k *. s.Sphere.radius;
          both = p.both_sides;
        }
  | None ->
      let r = s.Sphere.radius in
      ellipsoid p (Sphere.center s) (Vec.v r r r)

(* A plane across an axis fills a rectangle of its box. *)
let quadric_bounds q =
  let b = Quadric.bounds q in
  match Quadric.shape q with
  | Plane { normal = n; offset } ->
      let across a b c = a <> 0. && b = 0. && c = 0. in
      if across n.x n.y n.z then
        { b with x0 = offset /. n.x; x1 = offset /. n.x }
      else if across n.y n.z n.x then
        { b with y0 = offset /. n.y; y1 = offset /. n.y }
      else if across n.z n.x n.y then
        { b with z0 = offset /. n.z; z1 = offset /. n.z }
      else b
  | Matrix _ | Form _ | Ellipsoid _ | Cylinder _ | Cone _ | Paraboloid _
  | Hyperbolic_paraboloid _ | Hyperboloid_one_sheet _ | Hyperboloid_two_sheets _
    ->
      b

let quadric p q =
  match (Quadric.shape q, Quadric.clip q) with
  | Ellipsoid { center; radii }, None -> ellipsoid p center radii
  | ( ( Plane _ | Matrix _ | Form _ | Ellipsoid _ | Cylinder _ | Cone _
      | Paraboloid _ | Hyperbolic_paraboloid _ | Hyperboloid_one_sheet _
      | Hyperboloid_two_sheets _ ),
      (Some _ | None) ) ->
      box p Hull (quadric_bounds q)

let of_primitive (p : Primitives.t) =
  match p.shape with
  | Sphere s -> sphere p s
  | Box b -> box p (if p.both_sides then Hull else Facing) (Box.bounds b)
  | Quadric q -> quadric p q
  | Triangle { corners = { a; b; c }; _ } ->
      let a = placed p a and b = placed p b and c = placed p c in
      let visible = if p.both_sides then All else Facing in
      facets visible [ (if mirrors p then (a, c, b) else (a, b, c)) ]

let cap ~axis ~one_minus_cos t =
  match t with
  | Ball { center; radius; both = false } ->
      Cap
        {
          apex = Point.along center (axis : Dir.t :> Vec.t) radius;
          frame = Frame.of_dir axis;
          radius;
          one_minus_cos;
        }
  | Ball { both = true; _ } | Ellipsoid _ | Cap _ | Facets _ -> t

(* {1 Balls} *)

(* 1 − cos of the cone in which a ball is seen: 2 from inside, 0 if that side
   sends out nothing. The rounded surface counts as inside that does. *)
let ball_cone { radius; both; _ } distance =
  if distance > radius then Warp.cone_of_ball ~distance ~radius
  else if both || distance > radius *. (1. -. 0x1p-40) then 2.
  else 0.

let usable direction density =
  if density > 0. && density < infinity then Some { direction; density }
  else None

let anywhere p = usable (Warp.sphere p) (1. /. full)

let sample_ball ball from p =
  let way = Point.sub ball.center from in
  let one_minus_cos = ball_cone ball (Vec.norm way) in
  if one_minus_cos >= 2. then anywhere p
  else if one_minus_cos > 0. then
    let frame = Frame.of_dir (Dir.of_vec_or Dir.z way) in
    usable
      (Warp.to_world frame (Warp.cone ~one_minus_cos p :> Vec.t))
      (Warp.cone_density ~one_minus_cos)
  else None

let ball_density ball from (d : Dir.t) =
  let way = Point.sub ball.center from in
  let one_minus_cos = ball_cone ball (Vec.norm way) in
  if one_minus_cos >= 2. then 1. /. full
  else
    let apart = Vec.sub (d :> Vec.t) (Dir.of_vec_or Dir.z way :> Vec.t) in
    if 0.5 *. Vec.dot apart apart <= one_minus_cos && one_minus_cos > 0. then
      Warp.cone_density ~one_minus_cos
    else 0.

(* {1 Caps}

   Seen from their apex: the sphere is where |y|² + 2r a·y = 0, a being the axis
   and y the way from the apex; and 1 − cos of the angle from the axis is
   |y|²/2r². So nothing is lost to how large the sphere is beside its cap. *)

let cap_area { radius; one_minus_cos; _ } =
  2. *. Float.pi *. radius *. radius *. one_minus_cos

(* The density of the direction [d] in which the cap is met from outside; 0 if
   it is not. *)
let cap_density cap from (d : Dir.t) =
  let d = (d :> Vec.t) and a = (cap.frame.w :> Vec.t) and r = cap.radius in
  let o = Point.sub from cap.apex in
  let b = Vec.dot o d +. (r *. Vec.dot a d)
  and c = Vec.dot o o +. (2. *. r *. Vec.dot a o) in
  let discriminant = (b *. b) -. c in
  if not (b < 0. && c > 0. && discriminant > 0.) then 0.
  else
    let root = sqrt discriminant in
    let t = c /. (root -. b) in
    let y = Vec.along o d t in
    if Vec.dot y y <= 2. *. r *. r *. cap.one_minus_cos then
      let t = t /. r in
      t *. t *. r /. (2. *. Float.pi *. cap.one_minus_cos *. root)
    else 0.

let sample_cap cap from p =
  let { Vec.x; y; z } =
    (Warp.cone ~one_minus_cos:cap.one_minus_cos p : Dir.t :> Vec.t)
  in
  let { Frame.u; v; w } = cap.frame in
  let place z =
    Vec.along
      (Vec.along (Vec.scale x (u :> Vec.t)) (v :> Vec.t) y)
      (w :> Vec.t)
      z
  in
  let fall = ((x *. x) +. (y *. y)) /. (1. +. z) in
  let way = Vec.along (Point.sub cap.apex from) (place (-.fall)) cap.radius in
  if Vec.dot (place z) way < 0. then
    Option.bind (Dir.of_vec way) (fun d -> usable d (cap_density cap from d))
  else None

let cap_solid_angle cap from =
  let o = Point.sub from cap.apex in
  let outside =
    Vec.dot o o +. (2. *. cap.radius *. Vec.dot o (cap.frame.w :> Vec.t)) > 0.
  and radius = cap.radius *. sqrt (2. *. cap.one_minus_cos)
  and distance = Vec.norm o in
  if not outside then 0.
  else if distance > radius then
    2. *. Float.pi *. Warp.cone_of_ball ~distance ~radius
  else full

(* {1 Facets} *)

(* Twice the height of [from] above the facet has this sign. *)
let[@inline] height facet from = Vec.dot facet.normal (Point.sub from facet.a)

let seen visible facets from =
  match visible with
  | All -> facets
  | Facing | Hull -> List.filter (fun f -> height f from > 0.) facets

let spherical from f =
  let t =
    Spherical_triangle.make (Point.sub f.a from) (Point.sub f.b from)
      (Point.sub f.c from)
  in
  if Spherical_triangle.solid_angle t > 0. then Some t else None

(* [u] of the [total] is still to be passed over. *)
let rec pick total u v = function
  | [] -> None
  | t :: rest -> (
      let part = Spherical_triangle.solid_angle t in
      match rest with
      | _ :: _ when u >= part -> pick total (u -. part) v rest
      | [] | _ :: _ ->
          let u = Float.min (u /. part) (Float.pred 1.) in
          usable (Spherical_triangle.sample t { u; v }) (1. /. total))

(* Is [d] between the three corners? Of each two, their plane has it on the side
   of the third. The edges keep the digits of a small facet seen from afar. *)
let holds from (d : Vec.t) f =
  let side = -.Float.copy_sign 1. (height f from) in
  let inside p q =
    side *. Vec.dot d (Vec.cross (Point.sub p from) (Point.sub q p)) >= 0.
  in
  inside f.a f.b && inside f.b f.c && inside f.c f.a

let facets_density visible facets from (d : Dir.t) =
  match (seen visible facets from, visible, facets) with
  | [], Hull, _ :: _ -> 1. /. full
  | seen, (Hull | All | Facing), _ ->
      if List.exists (holds from (d :> Vec.t)) seen then
        let total =
          Spherical_triangle.total (List.filter_map (spherical from) seen)
        in
        if total > 0. then 1. /. total else 0.
      else 0.

(* {1 All} *)

type look = Curved | Everything | Triangles of Spherical_triangle.t list

let nothing = Curved

let look t ~from =
  match t with
  | Ball _ | Ellipsoid _ | Cap _ -> Curved
  | Facets { visible; facets } -> (
      match (seen visible facets from, visible, facets) with
      | [], Hull, _ :: _ -> Everything
      | seen, (Hull | All | Facing), _ ->
          Triangles (List.filter_map (spherical from) seen))

let sample_seen look t ~from (p : Pattern.position) =
  match (look, t) with
  | Everything, _ -> anywhere p
  | Triangles triangles, _ ->
      let total = Spherical_triangle.total triangles in
      pick total (p.u *. total) p.v triangles
  | Curved, Ball ball -> sample_ball ball from p
  | Curved, Ellipsoid e -> Ellipsoid_target.sample e ~from p
  | Curved, Cap cap -> sample_cap cap from p
  | Curved, Facets _ -> None

let sample t ~from p = sample_seen (look t ~from) t ~from p

let density t ~from d =
  match t with
  | Ball ball -> ball_density ball from d
  | Ellipsoid e -> Ellipsoid_target.density e ~from d
  | Cap cap -> cap_density cap from d
  | Facets { visible; facets } -> facets_density visible facets from d

let solid_angle_seen look t ~from =
  match (look, t) with
  | Everything, _ -> full
  | Triangles triangles, _ -> Spherical_triangle.total triangles
  | Curved, Ball ball ->
      2. *. Float.pi *. ball_cone ball (Vec.norm (Point.sub ball.center from))
  | Curved, Ellipsoid e -> Ellipsoid_target.solid_angle e ~from
  | Curved, Cap cap -> cap_solid_angle cap from
  | Curved, Facets _ -> 0.

let solid_angle t ~from = solid_angle_seen (look t ~from) t ~from

let facet_area { a; b; c; _ } =
  0.5 *. Vec.norm (Vec.cross (Point.sub b a) (Point.sub c a))

let area = function
  | Ball { radius; _ } -> full *. radius *. radius
  | Ellipsoid e -> Ellipsoid_target.area e
  | Cap cap -> cap_area cap
  | Facets { facets; _ } ->
      List.fold_left (fun sum f -> sum +. facet_area f) 0. facets

let is_flat = function
  | Facets _ -> true
  | Ball _ | Ellipsoid _ | Cap _ -> false

let around center r =
  let at x y z = Point.add center (Vec.v (x *. r) (y *. r) (z *. r)) in
  let both f = [ f (-1.); f 1. ] in
  List.concat (both (fun x -> List.concat (both (fun y -> both (at x y)))))

let corners = function
  | Ball { center; radius; _ } -> around center radius
  | Ellipsoid e -> Ellipsoid_target.corners e
  | Cap { apex; radius; one_minus_cos; _ } ->
      around apex (radius *. sqrt (2. *. one_minus_cos))
  | Facets { facets; _ } -> List.concat_map (fun f -> [ f.a; f.b; f.c ]) facets

let ball = function
  | Ball { center; radius; _ } -> Some (center, radius)
  | Ellipsoid _ | Cap _ | Facets _ -> None

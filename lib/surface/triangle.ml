open Candor_number
open Candor_space

type corners = { a : Point.t; b : Point.t; c : Point.t }
[@@deriving show, eq, ord]

type uv = {
  ua : float;
  va : float;
  ub : float;
  vb : float;
  uc : float;
  vc : float;
}
[@@deriving show, eq, ord]

type t = {
  corners : corners;
  normals : (Dir.t * Dir.t * Dir.t) option;
  uv : uv option;
}
[@@deriving show, eq, ord]

let exact_diff (p : Point.t) (q : Point.t) =
  {
    Expansion.x = Expansion.diff p.x q.x;
    y = Expansion.diff p.y q.y;
    z = Expansion.diff p.z q.z;
  }

let size (p : Point.t) = Vec.largest (Point.sub p Point.origin)
let size_of { a; b; c } = Float.max (size a) (Float.max (size b) (size c))

let shift e (p : Point.t) =
  Point.v (Float.ldexp p.x e) (Float.ldexp p.y e) (Float.ldexp p.z e)

let rescaled e { a; b; c } = { a = shift e a; b = shift e b; c = shift e c }

(* The power of two that brings numbers up to [m] near 2^300: exact, and the
   products of three of them are then as far from overflow as can be, which
   keeps their smallest bits from underflow. *)
let raise_to_300 m = 300 - snd (Float.frexp m)

let has_area corners =
  let { a; b; c } = rescaled (raise_to_300 (size_of corners)) corners in
  let n = Expansion.cross (exact_diff b a) (exact_diff c a) in
  Expansion.(sign n.x <> 0 || sign n.y <> 0 || sign n.z <> 0)

let directions (a, b, c) =
  match (Dir.of_vec a, Dir.of_vec b, Dir.of_vec c) with
  | Some a, Some b, Some c -> Ok (Some (a, b, c))
  | None, _, _ | _, None, _ | _, _, None -> Error "a normal must not be zero"

let make ?normals ?uv corners =
  let { a; b; c } = corners in
  if not (Reach.point a && Reach.point b && Reach.point c) then
    Error Reach.message
  else if not (has_area corners) then
    Error "the triangle has no area: its corners lie on one line"
  else
    match Option.fold ~none:(Ok None) ~some:directions normals with
    | Ok normals -> Ok { corners; normals; uv }
    | Error _ as e -> e

let bounds { corners = { a; b; c }; _ } = Bounds.of_points [ a; b; c ]

(* {1 Meeting} *)

let[@inline] largest3 (v : Vec.t) m =
  let x = Float.abs v.x and y = Float.abs v.y and z = Float.abs v.z in
  let m = if x > m then x else m in
  let m = if y > m then y else m in
  if z > m then z else m

(* The corners as seen from the origin, and the direction, all exact: lengths
   times 2^length, the direction times 2^time. *)
type view = {
  to_a : Expansion.vec;
  to_b : Expansion.vec;
  to_c : Expansion.vec;
  toward : Expansion.vec;
  length : int;
  time : int;
}

let view corners o (d : Vec.t) =
  let length = raise_to_300 (Float.max (size_of corners) (size o)) in
  let time = raise_to_300 (Vec.largest d) in
  let o = shift length o and { a; b; c } = rescaled length corners in
  let part x = Expansion.of_float (Float.ldexp x time) in
  {
    to_a = exact_diff a o;
    to_b = exact_diff b o;
    to_c = exact_diff c o;
    toward = { x = part d.x; y = part d.y; z = part d.z };
    length;
    time;
  }

(* The sign of d.((p - o) x (r - o)) with the tie broken. *)
let exact_edge d p r =
  let m = Expansion.cross p r in
  let rec first = function
    | [] -> 0
    | x :: rest -> ( match Expansion.sign x with 0 -> first rest | s -> s)
  in
  match Expansion.sign (Expansion.dot d m) with
  | 0 -> first [ m.x; m.y; m.z ]
  | s -> s

let exact_edges corners o d =
  let { to_a = a; to_b = b; to_c = c; toward = d; _ } = view corners o d in
  let ea = exact_edge d b c and eb = exact_edge d c a in
  if ea = eb && eb = exact_edge d a b then ea else 0

(* -1, 0 or 1: on which side of all three edges the ray passes, 0 if it passes
   outside of the triangle. *)
let crossing corners (o : Point.t) (d : Vec.t) =
  let a = Point.sub corners.a o
  and b = Point.sub corners.b o
  and c = Point.sub corners.c o in
  let ea = Vec.dot d (Vec.cross b c)
  and eb = Vec.dot d (Vec.cross c a)
  and ec = Vec.dot d (Vec.cross a b) in
  let m = largest3 a (largest3 b (largest3 c 0.)) in
  (* Shewchuk's bound for a 3x3 determinant is (7 + 56u)u times its permanent,
     which is at most 6 times the product of its rows' largest entries. *)
  let doubt = 0x1.6p-48 *. m *. m *. largest3 d 0. in
  if not (doubt > 0x1p-900 && doubt < 0x1p900) then exact_edges corners o d
  else if ea > doubt && eb > doubt && ec > doubt then 1
  else if ea < -.doubt && eb < -.doubt && ec < -.doubt then -1
  else if
    (ea > doubt || eb > doubt || ec > doubt)
    && (ea < -.doubt || eb < -.doubt || ec < -.doubt)
  then 0
  else exact_edges corners o d

let exact_distance corners o d =
  let view = view corners o d in
  let minus (p : Expansion.vec) (q : Expansion.vec) =
    let open Expansion in
    { x = sub p.x q.x; y = sub p.y q.y; z = sub p.z q.z }
  in
  let { to_a; to_b; to_c; toward; length; time } = view in
  let n = Expansion.cross (minus to_b to_a) (minus to_c to_a) in
  let t = Expansion.(ratio (dot to_a n) (dot toward n)) in
  Float.ldexp t (time - length)

(* Where the ray crosses the plane: ((a - o).n) / (d.n) with n = (b-a) x (c-a).
   Double-double, since near the plane or along it both dot products cancel.
   The sides and the direction are brought near 1 by powers of two, so that
   nothing overflows; then the dot products are off by less than 2^-99, and
   where that could matter they are taken exactly. *)
let plane_distance corners (o : Point.t) (direction : Vec.t) =
  let open Double_double in
  let diff (p : Point.t) (q : Point.t) =
    {
      x = Error_free.two_diff p.x q.x;
      y = Error_free.two_diff p.y q.y;
      z = Error_free.two_diff p.z q.z;
    }
  in
  let unit v =
    let larger a b = Float.max a (Float.abs b) in
    let m = larger (larger (larger 0. v.x.hi) v.y.hi) v.z.hi in
    let e = snd (Float.frexp m) in
    ({ x = shift (-e) v.x; y = shift (-e) v.y; z = shift (-e) v.z }, e)
  in
  let cross p q =
    {
      x = sub (mul p.y q.z) (mul p.z q.y);
      y = sub (mul p.z q.x) (mul p.x q.z);
      z = sub (mul p.x q.y) (mul p.y q.x);
    }
  in
  let side_b, _ = unit (diff corners.b corners.a)
  and side_c, _ = unit (diff corners.c corners.a)
  and offset, eo = unit (diff corners.a o)
  and d, ed =
    let { Vec.x; y; z } = direction in
    unit { x = of_float x; y = of_float y; z = of_float z }
  in
  let n = cross side_b side_c in
  let above = dot offset n and across = dot d n in
  let known x = Float.abs x.Error_free.hi > 0x1p-45 in
  if known above && known across then
    Float.ldexp (to_float (div above across)) (eo - ed)
  else exact_distance corners o direction

let meet s o d left cursor =
  if not (Contact.is_none left) then Contact.none
  else
    match crossing s.corners o d with
    | 0 -> Contact.none
    | sign ->
        let side : Side.t = if sign < 0 then Outside else Inside in
        let t = plane_distance s.corners o d in
        Cursor.take cursor t (Contact.v ~part:0 side)

(* {1 Locating} *)

let normal corners =
  let n =
    Vec.cross (Point.sub corners.b corners.a) (Point.sub corners.c corners.a)
  in
  match Dir.of_vec n with
  | Some n -> n
  | None ->
      (* The area underflows: its factors do not. *)
      let { a; b; c } = rescaled (raise_to_300 (size_of corners)) corners in
      Dir.of_vec_or Dir.z (Vec.cross (Point.sub b a) (Point.sub c a))

let clamp w = if w > 0. then if w < 1. then w else 1. else 0.

let locate { corners; normals; uv } o d =
  let a = Point.sub corners.a o
  and b = Point.sub corners.b o
  and c = Point.sub corners.c o in
  let ea = Vec.dot d (Vec.cross b c)
  and eb = Vec.dot d (Vec.cross c a)
  and ec = Vec.dot d (Vec.cross a b) in
  let sum = ea +. eb +. ec in
  let wb = clamp (eb /. sum) and wc = clamp (ec /. sum) in
  let wa = clamp (1. -. wb -. wc) in
  let mix x y z = (wa *. x) +. (wb *. y) +. (wc *. z) in
  let { a; b; c } = corners in
  let spread x y z =
    let size = mix (Float.abs x) (Float.abs y) (Float.abs z) in
    7. *. 0x1p-53 *. size
  in
  let smooth ((na : Dir.t), (nb : Dir.t), (nc : Dir.t)) =
    let na = (na :> Vec.t) and nb = (nb :> Vec.t) and nc = (nc :> Vec.t) in
    Dir.of_vec
      (Vec.v (mix na.x nb.x nc.x) (mix na.y nb.y nc.y) (mix na.z nb.z nc.z))
  in
  {
    Local.point = Point.v (mix a.x b.x c.x) (mix a.y b.y c.y) (mix a.z b.z c.z);
    normal = normal corners;
    error = Vec.v (spread a.x b.x c.x) (spread a.y b.y c.y) (spread a.z b.z c.z);
    flat = true;
    uv =
      lazy
        (match uv with
        | Some t -> Some (mix t.ua t.ub t.uc, mix t.va t.vb t.vc)
        | None -> Some (wb, wc));
    shading_normal = Option.bind normals smooth;
  }

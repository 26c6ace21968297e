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

(* (b - a) x (c - a), each component a sum of two doubles, the second with a
   prime, and the product of the largest components of the two factors. *)
type plane = {
  nx : float;
  ny : float;
  nz : float;
  nx' : float;
  ny' : float;
  nz' : float;
  size : float;
}
[@@deriving show, eq, ord]

type t = {
  corners : corners;
  plane : plane;
  normals : (Vec.t * Vec.t * Vec.t) option;
  uv : uv option;
}
[@@deriving show, eq, ord]

let size (p : Point.t) = Vec.largest (Point.sub p Point.origin)
let size_of { a; b; c } = Float.max (size a) (Float.max (size b) (size c))

let rescaled e { a; b; c } =
  { a = Point.ldexp e a; b = Point.ldexp e b; c = Point.ldexp e c }

(* The power of two that brings numbers up to [m] near 2^300: exact, and the
   products of three of them are then as far from overflow as can be, which
   keeps their smallest bits from underflow. *)
let raise_to_300 m = 300 - snd (Float.frexp m)

let has_area corners =
  let { a; b; c } = rescaled (raise_to_300 (size_of corners)) corners in
  let n = Expansion.cross (Unrounded.diff b a) (Unrounded.diff c a) in
  Expansion.(sign n.x <> 0 || sign n.y <> 0 || sign n.z <> 0)

let directions (a, b, c) =
  match (Dir.of_vec a, Dir.of_vec b, Dir.of_vec c) with
  | Some a, Some b, Some c -> Some (a, b, c)
  | None, _, _ | _, None, _ | _, _, None -> None

let plane { a; b; c } =
  let open Error_free in
  let p = Point.sub b a and q = Point.sub c a in
  let p' = Unrounded.diff_error b a p and q' = Unrounded.diff_error c a q in
  (* (p + p')_i (q + q')_j - (p + p')_j (q + q')_i *)
  let part i j =
    let pi = Vec.get p i and pj = Vec.get p j in
    let qi = Vec.get q i and qj = Vec.get q j in
    let m = pi *. qj and k = pj *. qi in
    let n = m -. k in
    two_sum n
      (sum_error m (-.k) n +. product_error pi qj m -. product_error pj qi k
      +. ((Vec.get p' i *. qj) +. (pi *. Vec.get q' j))
      -. ((Vec.get p' j *. qi) +. (pj *. Vec.get q' i)))
  in
  let x = part 1 2 and y = part 2 0 and z = part 0 1 in
  {
    nx = x.hi;
    ny = y.hi;
    nz = z.hi;
    nx' = x.lo;
    ny' = y.lo;
    nz' = z.lo;
    size = Vec.largest p *. Vec.largest q;
  }

let make ?normals ?uv corners =
  let { a; b; c } = corners in
  if not (Reach.point a && Reach.point b && Reach.point c) then
    Error Reach.message
  else if not (has_area corners) then
    Error "the triangle has no area: its corners lie on one line"
  else if
    Option.is_some normals && Option.is_none (Option.bind normals directions)
  then Error "a normal must be finite and not zero"
  else Ok { corners; plane = plane corners; normals; uv }

let bounds { corners = { a; b; c }; _ } = Bounds.of_points [ a; b; c ]

(* {1 Meeting} *)

let[@inline] largest x y z =
  let x = Float.abs x and y = Float.abs y and z = Float.abs z in
  let m = if y > x then y else x in
  if z > m then z else m

let[@inline] largest3 (v : Vec.t) m =
  let l = largest v.x v.y v.z in
  if l > m then l else m

(* The origin as seen from the corners, and the direction, all exact: lengths
   times 2^length, the direction times 2^time. *)
type view = {
  from_a : Expansion.vec;
  from_b : Expansion.vec;
  from_c : Expansion.vec;
  toward : Expansion.vec;
  length : int;
  time : int;
}

let view corners (ray : Object_ray.t) =
  let length = raise_to_300 (Float.max (size_of corners) (size ray.origin)) in
  let time = raise_to_300 (Vec.largest ray.direction) in
  let { a; b; c } = rescaled length corners in
  let ray = Object_ray.ldexp ~length ~time ray in
  {
    from_a = Object_ray.from ray a;
    from_b = Object_ray.from ray b;
    from_c = Object_ray.from ray c;
    toward = Object_ray.toward ray;
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

let exact_edges corners ray =
  let { from_a = a; from_b = b; from_c = c; toward = d; _ } =
    view corners ray
  in
  let ea = exact_edge d b c and eb = exact_edge d c a in
  if ea = eb && eb = exact_edge d a b then ea else 0

(* p - (o + o') *)
let[@inline] seen (p : Point.t) (o : Point.t) (o' : Vec.t) =
  Vec.v (p.x -. o.x -. o'.x) (p.y -. o.y -. o'.y) (p.z -. o.z -. o'.z)

(* -1, 0 or 1: on which side of all three edges the ray passes, 0 if it passes
   outside of the triangle. *)
let crossing corners (ray : Object_ray.t) cursor =
  let o = ray.origin and o' = ray.origin_low and d = ray.direction in
  let a = seen corners.a o o'
  and b = seen corners.b o o'
  and c = seen corners.c o o' in
  let ea = Vec.dot d (Vec.cross b c)
  and eb = Vec.dot d (Vec.cross c a)
  and ec = Vec.dot d (Vec.cross a b) in
  let m = largest3 a (largest3 b (largest3 c 0.)) in
  (* Shewchuk's bound for a 3x3 determinant is (7 + 56u)u times its permanent,
     which is at most 6 times the product of its rows' largest entries; the low
     parts of the ray add 3u at most. *)
  let doubt = 0x1p-47 *. m *. m *. largest3 d 0. in
  let sure = doubt > 0x1p-900 && doubt < 0x1p900 in
  if sure && ea > doubt && eb > doubt && ec > doubt then 1
  else if sure && ea < -.doubt && eb < -.doubt && ec < -.doubt then -1
  else if
    sure
    && (ea > doubt || eb > doubt || ec > doubt)
    && (ea < -.doubt || eb < -.doubt || ec < -.doubt)
  then 0
  else (
    Cursor.careful cursor;
    exact_edges corners ray)

let exact_distance corners ray =
  let view = view corners ray in
  let minus (p : Expansion.vec) (q : Expansion.vec) =
    let open Expansion in
    { x = sub p.x q.x; y = sub p.y q.y; z = sub p.z q.z }
  in
  let { from_a; from_b; from_c; toward; length; time } = view in
  let n = Expansion.cross (minus from_b from_a) (minus from_c from_a) in
  let t = Expansion.(ratio (dot from_a n) (neg (dot toward n))) in
  Float.ldexp t (time - length)

(* Where the ray crosses the plane: ((a - o).n) / (d.n). Near the plane or along
   it both products cancel, so they are taken in twice the precision; written
   out, since nothing here may allocate. *)
let plane_distance { corners; plane = n; _ } (ray : Object_ray.t) cursor =
  let open Error_free in
  let o = ray.origin and d = ray.direction and a = corners.a in
  let o' = ray.origin_low and d' = ray.direction_low in
  let rx = a.x -. o.x and ry = a.y -. o.y and rz = a.z -. o.z in
  let rx' = sum_error a.x (-.o.x) rx -. o'.x
  and ry' = sum_error a.y (-.o.y) ry -. o'.y
  and rz' = sum_error a.z (-.o.z) rz -. o'.z in
  let sum = dot d.x d.y d.z n.nx n.ny n.nz in
  let across =
    sum
    +. (dot_error d.x d.y d.z n.nx n.ny n.nz sum
       +. dot d.x d.y d.z n.nx' n.ny' n.nz'
       +. dot d'.x d'.y d'.z n.nx n.ny n.nz)
  in
  let sum = dot rx ry rz n.nx n.ny n.nz in
  let away =
    sum
    +. (dot_error rx ry rz n.nx n.ny n.nz sum
       +. dot rx ry rz n.nx' n.ny' n.nz'
       +. dot rx' ry' rz' n.nx n.ny n.nz)
  in
  (* Both are off by less than 2^-99 of the product of their largest factors, and
     by 2^-105 of what low parts stand for; where that could matter, or the range
     is left, they are taken exactly. *)
  let least_across = 0x1p-45 *. n.size *. largest d.x d.y d.z
  and least_away =
    0x1p-45 *. n.size *. (largest rx ry rz +. (0x1p48 *. largest o'.x o'.y o'.z))
  in
  if
    Float.abs across > least_across
    && Float.abs away > least_away
    && least_across > 0x1p-900 && least_away > 0x1p-900
    && Float.abs across < infinity
    && Float.abs away < infinity
  then away /. across
  else (
    Cursor.careful cursor;
    exact_distance corners ray)

let meet s ray left cursor =
  if not (Contact.is_none left) then Contact.none
  else
    match crossing s.corners ray cursor with
    | 0 -> Contact.none
    | sign ->
        let side : Side.t = if sign < 0 then Outside else Inside in
        let t = plane_distance s ray cursor in
        Cursor.take cursor t (Contact.v ~part:0 side)

(* {1 Locating} *)

(* A product of vectors is far below that of their sizes where it cancels: in
   needles, and seen from along the plane. Then it is taken exactly. *)
let[@inline] cancels x size = not (Float.abs x > 0x1p-16 *. size)

let exact_normal corners =
  let { a; b; c } = rescaled (raise_to_300 (size_of corners)) corners in
  let n = Expansion.cross (Unrounded.diff b a) (Unrounded.diff c a) in
  Vec.v (Expansion.to_float n.x) (Expansion.to_float n.y)
    (Expansion.to_float n.z)

let normal { corners; plane = { nx; ny; nz; size; _ }; _ } =
  let n = Vec.v nx ny nz in
  let plain = size > 0x1p-900 && not (cancels (Vec.largest n) size) in
  Dir.of_vec_or Dir.z (if plain then n else exact_normal corners)

let exact_weights corners ray =
  let { from_a; from_b; from_c; toward; _ } = view corners ray in
  let volume p q = Expansion.(dot toward (cross p q)) in
  let eb = volume from_c from_a and ec = volume from_a from_b in
  let sum = Expansion.(add (volume from_b from_c) (add eb ec)) in
  (Expansion.ratio eb sum, Expansion.ratio ec sum)

(* The weights of b and c where the line crosses the plane. *)
let weights { corners; plane; _ } (ray : Object_ray.t) =
  let p = Point.sub corners.b corners.a
  and q = Point.sub corners.c corners.a
  and r = seen corners.a ray.origin ray.origin_low
  and d = ray.direction in
  let across = Vec.dot d (Vec.v plane.nx plane.ny plane.nz) in
  let size = plane.size *. Vec.largest d in
  let far = size *. Vec.largest r in
  if cancels across size || not (far > 0x1p-900 && far < 0x1p900) then
    exact_weights corners ray
  else (Vec.dot d (Vec.cross q r) /. across, Vec.dot d (Vec.cross r p) /. across)

(* Weights stay this far from 0, so that at an edge the point, as rounded, is on
   the inner side of the neighbours of a convex mesh. *)
let margin = 0x1p-48
let clamp w ~most = if w > margin then if w < most then w else most else margin

(* From each corner, the point is brought onto the tangent plane there if it is
   behind that; the mean of this is where the curved surface bulges to. It is a
   little beyond a sphere, so that the edges of the mesh are out of the way of
   all that this surface faces. After J. Hanika, Hacking the Shadow Terminator,
   Ray Tracing Gems II, 2021. *)
let smooth { a; b; c } wb wc ((na : Dir.t), (nb : Dir.t), (nc : Dir.t)) =
  let wa = 1. -. wb -. wc in
  let na = (na :> Vec.t) and nb = (nb :> Vec.t) and nc = (nc :> Vec.t) in
  let mix x y z =
    Vec.add (Vec.scale x na) (Vec.add (Vec.scale y nb) (Vec.scale z nc))
  in
  let ab = Point.sub b a and ac = Point.sub c a and bc = Point.sub c b in
  (* How far the tangent planes are above the point. *)
  let ha = -.Vec.dot na (Vec.add (Vec.scale wb ab) (Vec.scale wc ac))
  and hb = Vec.dot nb (Vec.sub (Vec.scale wa ab) (Vec.scale wc bc))
  and hc = Vec.dot nc (Vec.add (Vec.scale wa ac) (Vec.scale wb bc)) in
  let up h = if h > 0. then h else 0. and down h = if h < 0. then h else 0. in
  let above = mix (wa *. up ha) (wb *. up hb) (wc *. up hc)
  and below = mix (wa *. down ha) (wb *. down hb) (wc *. down hc) in
  Dir.of_vec (mix wa wb wc)
  |> Option.map (fun outward -> { Local.outward; above; below })

let locate ({ corners; normals; uv; _ } as s) ray =
  let wb, wc = weights s ray in
  (* Together they stay 1, or the point would leave the plane. *)
  let wb = clamp wb ~most:(1. -. (2. *. margin)) in
  let wc = clamp wc ~most:(1. -. wb -. margin) in
  let wa = 1. -. wb -. wc in
  let mix x y z = (wa *. x) +. (wb *. y) +. (wc *. z) in
  let { a; b; c } = corners in
  let spread x y z =
    let size = mix (Float.abs x) (Float.abs y) (Float.abs z) in
    7. *. 0x1p-53 *. size
  in
  {
    Local.point = Point.v (mix a.x b.x c.x) (mix a.y b.y c.y) (mix a.z b.z c.z);
    normal = normal s;
    error = Vec.v (spread a.x b.x c.x) (spread a.y b.y c.y) (spread a.z b.z c.z);
    flat = true;
    uv =
      lazy
        (match uv with
        | Some t -> Some (mix t.ua t.ub t.uc, mix t.va t.vb t.vc)
        | None -> Some (wb, wc));
    smooth = Option.bind (Option.bind normals directions) (smooth corners wb wc);
  }

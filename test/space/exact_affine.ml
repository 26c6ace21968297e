(** Affine maps in rationals: rows of a linear part, and a translation. *)

open Candor_space
open Candor_oracle
open Exact

type t = { rows : vec * vec * vec; shift : vec }

let of_affine (m : Affine.t) =
  { rows = Maps.rows m; shift = v (q m.xt) (q m.yt) (q m.zt) }

let map2 f a b =
  let ax, ay, az = a.rows and bx, by, bz = b.rows in
  { rows = (f ax bx, f ay by, f az bz); shift = f a.shift b.shift }

let of_wide (m : Wide_affine.t) = map2 add (of_affine m.high) (of_affine m.low)
let vector { rows = a, b, c; _ } u = v (dot a u) (dot b u) (dot c u)
let point m p = add (vector m p) m.shift

let transposed { rows = a, b, c; _ } =
  (v a.x b.x c.x, v a.y b.y c.y, v a.z b.z c.z)

let after b a =
  let x, y, z = transposed a in
  let columns = (vector b x, vector b y, vector b z) in
  { rows = transposed { b with rows = columns }; shift = point b a.shift }

let determinant { rows = a, b, c; _ } = dot a (cross b c)

(** [inverse m] undoes [m], whose determinant is not 0. *)
let inverse m =
  let a, b, c = m.rows in
  let over n = scale (one / determinant m) n in
  let columns = (over (cross b c), over (cross c a), over (cross a b)) in
  let linear = { m with rows = transposed { m with rows = columns } } in
  { linear with shift = scale (Q.neg one) (vector linear m.shift) }

let abs { x; y; z } = v (Q.abs x) (Q.abs y) (Q.abs z)

let absolute { rows = a, b, c; shift } =
  { rows = (abs a, abs b, abs c); shift = abs shift }

(** [within k a b sizes] is whether each component of [a − b] is at most [k]
    times that of [sizes]. *)
let within k a b sizes =
  let off = abs (sub a b) and most = scale k sizes in
  Q.leq off.x most.x && Q.leq off.y most.y && Q.leq off.z most.z

let all_within k a b sizes =
  let { rows = x, y, z; shift } = map2 sub a b in
  let zero = v zero zero zero in
  let sx, sy, sz = sizes.rows in
  within k x zero sx && within k y zero sy && within k z zero sz
  && within k shift zero sizes.shift

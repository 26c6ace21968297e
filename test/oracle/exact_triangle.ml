(** Triangles in exact arithmetic, ties broken by the simulation of simplicity
    that [Triangle.meet] documents: d moves to d + (ε, ε², ε³). *)

open Candor_space
open Candor_surface

let rec first_sign = function
  | [] -> 0
  | x :: rest -> ( match Dyadic.sign x with 0 -> first_sign rest | s -> s)

(** [edge d p r] is the side on which a line along [d] passes the edge from [p]
    to [r], both seen from its origin. *)
let edge d p r =
  let m = Dyadic_vec.cross p r in
  first_sign [ Dyadic_vec.dot d m; m.x; m.y; m.z ]

(* Whether a blurred line may pass on either side of an edge, and no two edges
   say for sure that it misses. *)
let band (line : Line.t) edges =
  let open Dyadic in
  let d = line.direction in
  let sure (p, r) =
    let size = Dyadic_vec.size in
    let off =
      (line.blur.of_direction * size p * size r)
      + (line.blur.of_origin * size d * (size p + size r))
    in
    let e = Dyadic_vec.(dot d (cross p r)) in
    if leq (abs e) (shift 1 off) then 0 else sign e
  in
  let signs = List.map sure edges in
  List.mem 0 signs && not (List.mem 1 signs && List.mem (-1) signs)

let slack (line : Line.t) n at across =
  if Line.is_sharp line then Dyadic.zero
  else
    let open Wide in
    let t = abs (Exact_root.estimate at) in
    let off =
      add
        (of_dyadic line.blur.of_origin)
        (mul t (of_dyadic line.blur.of_direction))
    in
    let size = of_dyadic (Dyadic_vec.size n) in
    Crossing.slack (div (mul off size) (abs (of_dyadic across)))

let truth_along (s : Triangle.t) (line : Line.t) =
  let { Triangle.a; b; c } = s.corners in
  let a = Dyadic_vec.point a
  and b = Dyadic_vec.point b
  and c = Dyadic_vec.point c in
  let open Dyadic_vec in
  let n = cross (sub b a) (sub c a) and d = line.direction in
  let across = dot d n in
  let seen p = neg (Line.from line p) in
  let a = seen a and b = seen b and c = seen c in
  let at = lazy (Exact_root.ratio (dot a n) across) in
  let crossings =
    let first = edge d b c in
    if
      Dyadic.sign across <> 0
      && first <> 0
      && edge d c a = first
      && edge d a b = first
    then
      let side : Side.t = if Dyadic.sign across < 0 then Outside else Inside in
      [ { Crossing.at = Lazy.force at; side; part = 0 } ]
    else []
  in
  if Line.is_sharp line || Dyadic.sign across = 0 then
    Crossing.exactly crossings
  else
    {
      crossings;
      band = lazy (band line [ (b, c); (c, a); (a, b) ]);
      slack = slack line n (Lazy.force at) across;
    }

(** [truth s line] is where [line] crosses [s]. *)
let truth s line = truth_along s (Crossing.exact line)

open Exact

let corners (s : Triangle.t) =
  let { Triangle.a; b; c } = s.corners in
  (point a, point b, point c)

(** [normal s] is the normal of [s], of any length. *)
let normal s =
  let a, b, c = corners s in
  cross (sub b a) (sub c a)

(** [value s p] is the signed volume over the triangle: > 0 outside. *)
let value s p =
  let a, _, _ = corners s in
  dot (normal s) (sub p a)

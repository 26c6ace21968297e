open Candor_number

let vec (a : Vec.t) =
  let open Expansion in
  { x = of_float a.x; y = of_float a.y; z = of_float a.z }

let diff (p : Point.t) (q : Point.t) =
  let open Expansion in
  { x = diff p.x q.x; y = diff p.y q.y; z = diff p.z q.z }

let pair_diff (p : Point.t) (q : Point.t) =
  let open Error_free in
  {
    Double_double.x = two_diff p.x q.x;
    y = two_diff p.y q.y;
    z = two_diff p.z q.z;
  }

let diff_error (p : Point.t) (q : Point.t) (d : Vec.t) =
  let open Error_free in
  Vec.v
    (sum_error p.x (-.q.x) d.x)
    (sum_error p.y (-.q.y) d.y)
    (sum_error p.z (-.q.z) d.z)

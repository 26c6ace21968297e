type t = Double_double.t

let zero = Double_double.of_float 0.

(* Beyond the finite doubles an error has no meaning: it would be nan. *)

let[@inline] add (s : t) x =
  let hi = s.hi +. x in
  if Float.is_finite hi then
    Error_free.two_sum hi (s.lo +. Error_free.sum_error s.hi x hi)
  else Double_double.of_float hi

let join (a : t) (b : t) =
  let hi = a.hi +. b.hi in
  if Float.is_finite hi then Double_double.add a b
  else Double_double.of_float hi

let[@inline] accumulate a i x =
  let s = add { hi = Float.Array.get a i; lo = Float.Array.get a (i + 1) } x in
  Float.Array.set a i s.hi;
  Float.Array.set a (i + 1) s.lo

let held a i : t = { hi = Float.Array.get a i; lo = Float.Array.get a (i + 1) }
let total (s : t) = s.hi

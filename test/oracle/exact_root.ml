(** Real roots of quadratics with rational coefficients, compared with rationals
    by signs alone: no square root, no rounding. *)

open Exact

type t =
  | Ratio of Q.t
  | Lower of { a : Q.t; h : Q.t; c : Q.t }
      (** the lower root of a t² + 2 h t + c, where a > 0 and it is real *)
  | Upper of { a : Q.t; h : Q.t; c : Q.t }

(** [discriminant (a, h, c)] is h² − a c. *)
let discriminant (a, h, c) = (h * h) - (a * c)

(** [of_quadratic (a, h, c)] are the roots in order; none where the polynomial
    is constant. *)
let of_quadratic (a, h, c) =
  match Q.sign a with
  | 0 -> if Q.sign h = 0 then [] else [ Ratio (Q.neg c / (two * h)) ]
  | s ->
      if Q.sign (discriminant (a, h, c)) < 0 then []
      else
        let k = Q.of_int s in
        let a = k * a and h = k * h and c = k * c in
        [ Lower { a; h; c }; Upper { a; h; c } ]

(** [compare r x] is the sign of [r − x]. *)
let compare r x =
  let signs a h c =
    (Q.sign ((x * ((a * x) + (two * h))) + c), Q.sign ((a * x) + h))
  in
  match r with
  | Ratio t -> Q.compare t x
  | Lower { a; h; c } -> (
      match signs a h c with 1, -1 -> 1 | 0, (-1 | 0) -> 0 | _ -> -1)
  | Upper { a; h; c } -> (
      match signs a h c with -1, _ | _, -1 -> 1 | 0, (0 | 1) -> 0 | _ -> -1)

let sign r = compare r zero

(** [approximate r] is [r] to some 250 bits. *)
let approximate = function
  | Ratio t -> t
  | (Lower { a; h; c } | Upper { a; h; c }) as r -> (
      let s = Exact.sqrt (discriminant (a, h, c)) in
      match r with
      | Lower _ when Q.sign h < 0 -> c / (s - h)
      | Upper _ when Q.sign h > 0 -> c / Q.neg (h + s)
      | Lower _ -> Q.neg (h + s) / a
      | Ratio _ | Upper _ -> (s - h) / a)

(** [near r x slack] is whether |r − x| ≤ slack. *)
let near r x slack = compare r (x - slack) >= 0 && compare r (x + slack) <= 0

(** [times r k] is [k·r] for [k > 0]. *)
let times k = function
  | Ratio t -> Ratio (k * t)
  | Lower { a; h; c } -> Lower { a; h = k * h; c = k * k * c }
  | Upper { a; h; c } -> Upper { a; h = k * h; c = k * k * c }

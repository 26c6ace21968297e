(** Real roots of quadratics with exact coefficients, compared with numbers by
    signs alone: no square root, no rounding. *)

open Dyadic

type quadratic = {
  a : Dyadic.t;
  h : Dyadic.t;
  c : Dyadic.t;
  discriminant : Dyadic.t;  (** h² − a c *)
}
(** a t² + 2 h t + c *)

type t =
  | Ratio of { over : Dyadic.t; under : Dyadic.t }  (** where under > 0 *)
  | Lower of quadratic  (** the lower root, where a > 0 and it is real *)
  | Upper of quadratic

(** [ratio n d] is n/d, for d other than 0. *)
let ratio n d =
  if Dyadic.sign d > 0 then Ratio { over = n; under = d }
  else Ratio { over = neg n; under = neg d }

(** [of_number x] is [x]. *)
let of_number over = Ratio { over; under = one }

(** [quadratic (a, h, c)] is that polynomial. *)
let quadratic (a, h, c) = { a; h; c; discriminant = (h * h) - (a * c) }

(** [roots p] are the roots in order; none where [p] is constant. *)
let roots p =
  match Dyadic.sign p.a with
  | 0 -> if Dyadic.sign p.h = 0 then [] else [ ratio (neg p.c) (shift 1 p.h) ]
  | s ->
      if Dyadic.sign p.discriminant < 0 then []
      else
        let p =
          if s > 0 then p else { p with a = neg p.a; h = neg p.h; c = neg p.c }
        in
        [ Lower p; Upper p ]

(** [of_quadratic (a, h, c)] are those of a t² + 2 h t + c. *)
let of_quadratic (a, h, c) =
  let whole x y z = of_z Z.(Q.num x * Q.den y * Q.den z) in
  roots (quadratic (whole a h c, whole h a c, whole c a h))

(** [against r n d] is the sign of [r − n/d], for d > 0. *)
let against r n d =
  let slope { a; h; _ } = (a * n) + (h * d) in
  let value p g = Dyadic.sign ((n * (g + (p.h * d))) + (p.c * d * d)) in
  match r with
  | Ratio { over; under } -> Dyadic.compare (over * d) (n * under)
  | Lower p -> (
      let g = slope p in
      if Dyadic.sign g > 0 then -1
      else match value p g with 0 -> 0 | s -> if s > 0 then 1 else -1)
  | Upper p -> (
      let g = slope p in
      if Dyadic.sign g < 0 then 1 else match value p g with 0 -> 0 | s -> -s)

(** [compare r x] is the sign of [r − x]. *)
let compare r x =
  let n, d = Dyadic.fraction x in
  against r n d

let sign r = against r zero one

(** [approximate r] is [r] to some 250 bits. *)
let approximate r =
  let open Exact in
  let exactly p = Dyadic.(to_q p.a, to_q p.h, to_q p.c, to_q p.discriminant) in
  match r with
  | Ratio { over; under } -> Dyadic.to_q over / Dyadic.to_q under
  | Lower p ->
      let a, h, c, d = exactly p in
      let s = sqrt d in
      if Q.sign h < 0 then c / (s - h) else Q.neg (h + s) / a
  | Upper p ->
      let a, h, c, d = exactly p in
      let s = sqrt d in
      if Q.sign h > 0 then c / Q.neg (h + s) else (s - h) / a

(** [before r s] is whether r ≤ s; between roots of different quadratics, as far
    as 250 bits can tell. *)
let before r s =
  match (r, s) with
  | _, Ratio { over; under } -> against r over under <= 0
  | Ratio { over; under }, _ -> against s over under >= 0
  | Lower p, Upper q when p == q -> true
  | Upper p, Lower q when p == q -> false
  | _ -> compare r (approximate s) <= 0

(** [near r x slack] is whether |r − x| ≤ slack. *)
let near r x slack =
  against r (x - slack) one >= 0 && against r (x + slack) one <= 0

(** [estimate r] is [r] up to some 2^-48 of itself. *)
let estimate r =
  let open Wide in
  match r with
  | Ratio { over; under } -> div (of_dyadic over) (of_dyadic under)
  | Lower p | Upper p -> (
      let a = of_dyadic p.a and h = of_dyadic p.h and c = of_dyadic p.c in
      let s = sqrt (of_dyadic p.discriminant) in
      match r with
      | Lower _ when h.x < 0. -> div c (sub s h)
      | Upper _ when h.x > 0. -> neg (div c (add h s))
      | Lower _ -> neg (div (add h s) a)
      | Ratio _ | Upper _ -> div (sub s h) a)

(** [distance r x] is |r − x|, up to some 2^-48 of itself. *)
let distance r x =
  let value p g = Wide.of_dyadic ((x * (g + p.h)) + p.c) in
  let root p = Wide.(sqrt (of_dyadic p.discriminant)) in
  let by_slope p g s ~ahead =
    (* Of the two ways to write it the one where nothing cancels. *)
    let g' = Wide.of_dyadic g in
    if ahead then Wide.(div (add (abs g') s) (of_dyadic p.a))
    else
      let both = Wide.add (Wide.abs g') s in
      if both.x = 0. then Wide.zero else Wide.div (value p g) both
  in
  Wide.abs
    (match r with
    | Ratio { over; under } ->
        Wide.(div (of_dyadic Dyadic.(over - (x * under))) (of_dyadic under))
    | Lower p ->
        let g = (p.a * x) + p.h in
        by_slope p g (root p) ~ahead:(Dyadic.sign g > 0)
    | Upper p ->
        let g = (p.a * x) + p.h in
        by_slope p g (root p) ~ahead:(Dyadic.sign g < 0))

(** [times r k] is [k·r] for [k > 0]. *)
let times k = function
  | Ratio { over; under } -> Ratio { over = k * over; under }
  | Lower { a; h; c; discriminant } ->
      Lower { a; h = k * h; c = k * k * c; discriminant = k * k * discriminant }
  | Upper { a; h; c; discriminant } ->
      Upper { a; h = k * h; c = k * k * c; discriminant = k * k * discriminant }

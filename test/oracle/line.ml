(** Lines with exact homogeneous coordinates: what a ray is, and what it becomes
    in the space of a group, without any division. *)

open Candor_space

type t = {
  origin : Dyadic_vec.t;
  direction : Dyadic_vec.t;
  weight : Dyadic.t;
  blur : blur;
}
(** The points (origin + t·direction) / weight, where weight > 0. *)

and blur = { of_origin : Dyadic.t; of_direction : Dyadic.t }
(** How far each component may be off before a surface that sees the line so is
    wrong. *)

let sharp = { of_origin = Dyadic.zero; of_direction = Dyadic.zero }

let of_ray (r : Ray.t) =
  {
    origin = Dyadic_vec.point r.origin;
    direction = Dyadic_vec.vec r.direction;
    weight = Dyadic.one;
    blur = sharp;
  }

(** [of_rationals origin direction] is that line. *)
let of_rationals (o : Exact.vec) (d : Exact.vec) =
  let weight =
    List.fold_left
      (fun w q -> Z.lcm w (Q.den q))
      Z.one
      [ o.x; o.y; o.z; d.x; d.y; d.z ]
  in
  let whole q = Dyadic.of_z (Z.divexact (Z.mul (Q.num q) weight) (Q.den q)) in
  let vec (a : Exact.vec) = Dyadic_vec.v (whole a.x) (whole a.y) (whole a.z) in
  {
    origin = vec o;
    direction = vec d;
    weight = Dyadic.of_z weight;
    blur = sharp;
  }

(** [is_sharp l] is whether nothing is forgiven for a blur. *)
let is_sharp l =
  Dyadic.sign l.blur.of_origin = 0 && Dyadic.sign l.blur.of_direction = 0

(** [from l p] is the vector from the point [p] to the line's origin, times the
    weight. *)
let from l p = Dyadic_vec.(sub l.origin (scale l.weight p))

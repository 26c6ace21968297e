(** Lines taken back through nested affine maps, exactly. *)

open Candor_space
open Dyadic_vec

(* The columns of the adjugate, the translation and the determinant. *)
type back = { c0 : t; c1 : t; c2 : t; shift : t; det : Dyadic.t }

let back (m : Affine.t) =
  let r0 = of_floats m.xx m.xy m.xz
  and r1 = of_floats m.yx m.yy m.yz
  and r2 = of_floats m.zx m.zy m.zz in
  let c0 = cross r1 r2 and c1 = cross r2 r0 and c2 = cross r0 r1 in
  { c0; c1; c2; shift = of_floats m.xt m.yt m.zt; det = dot r0 c0 }

let apply b a = add (scale a.x b.c0) (add (scale a.y b.c1) (scale a.z b.c2))

(* The greatest sum of a row of the inverse's absolute entries. *)
let norm { c0; c1; c2; det; _ } =
  let row f = Dyadic.(abs (f c0) + abs (f c1) + abs (f c2)) in
  let rows = [ row (fun c -> c.x); row (fun c -> c.y); row (fun c -> c.z) ] in
  let most = List.fold_left Dyadic.max Dyadic.zero rows in
  Wide.(div (of_dyadic most) (abs (of_dyadic det)))

(** [into ~blur maps line] is [line] in the space of the innermost of [maps],
    which stand outermost first: by the exact inverse of each. What is rounded
    on the way, [blur] of all that adds up to a coordinate, is forgiven. *)
let into ~blur maps (line : Line.t) =
  let step (l : Line.t) b =
    let sign a = if Dyadic.sign b.det < 0 then neg a else a in
    {
      l with
      origin = sign (apply b (sub l.origin (scale l.weight b.shift)));
      direction = sign (apply b l.direction);
      weight = Dyadic.(l.weight * abs b.det);
    }
  in
  let widen (reach, speed) b =
    let k = norm b in
    let far = Wide.(add reach (of_dyadic (size b.shift))) in
    Wide.(mul k far, mul k speed)
  in
  let backs = List.map back maps in
  let inner = List.fold_left step line backs in
  let reach, speed =
    List.fold_left widen
      Wide.(of_dyadic (size line.origin), of_dyadic (size line.direction))
      backs
  in
  let forgiven x =
    Dyadic.(Wide.to_dyadic (Wide.mul (Wide.of_float blur) x) * inner.weight)
  in
  {
    inner with
    blur = { of_origin = forgiven reach; of_direction = forgiven speed };
  }

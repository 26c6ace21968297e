(* The oracle's quick ways against its slow one: roots to 250 bits. *)

open Candor_oracle
open Candor_surface_families
open QCheck2

let coefficients =
  let n = Gen.oneof [ Draw.small 6; Draw.coordinate ] in
  Gen.(pair (Draw.map3 (fun a h c -> (a, h, c)) n n n) (pair bool n))

let show ((a, h, c), (near, x)) =
  Printf.sprintf "%h %h %h, %s %h" a h c
    (if near then "beside a root by" else "at")
    x

(* Every root of the polynomial with a number [x] near it or anywhere. *)
let each holds ((a, h, c), (near, x)) =
  let roots = Exact_root.of_quadratic Exact.(q a, q h, q c) in
  List.for_all
    (fun r ->
      let t = Exact_root.approximate r in
      let at = Q.to_float t in
      let x = if near then at +. (x *. Exact.ulp at) else x in
      (not (Float.is_finite x)) || holds r t x)
    roots

let close wide exact =
  let found = Dyadic.to_q (Wide.to_dyadic wide) in
  Q.leq (Q.abs Exact.(found - exact)) Exact.(power (-44) * Q.abs exact)

let distance r t x =
  (* The slow way knows 2^-250 of the root. *)
  let exact = Q.abs Exact.(t - q x) in
  let known = Exact.(power (-200) * Q.abs t) in
  Q.leq exact known || close (Exact_root.distance r (Dyadic.of_float x)) exact

let estimate r t _ = close (Exact_root.estimate r) t

let signs r t x =
  let exact = Exact.(t - q x) in
  Q.leq (Q.abs exact) Exact.(power (-200) * Q.abs t)
  || Exact_root.compare r (Exact.q x) = Q.sign exact

let order ((a, h, c), _) =
  let roots = Exact_root.of_quadratic Exact.(q a, q h, q c) in
  match roots with
  | [ lower; upper ] ->
      Exact_root.before lower upper
      && Q.leq (Exact_root.approximate lower) (Exact_root.approximate upper)
  | _ -> true

(* The polygon's winding sees what its one triangle sees. *)
let winding { Family.shape = s; ray } =
  let { Candor_surface.Triangle.a; b; c } = s.Candor_surface.Triangle.corners in
  let line = Line.of_ray ray in
  let seen (t : Crossing.truth) =
    List.map (fun (c : Crossing.t) -> (c.side, c.part)) t.crossings
  in
  seen (Exact_triangle.truth_along s line)
  = seen (Exact_polygon.truth_along [ a; b; c ] line)

let suite =
  let law name = Law.law ~count:5000 ~print:show name coefficients in
  ( "oracle",
    [
      law "distances from roots are known to 2^-44" (each distance);
      law "roots are estimated to 2^-44" (each estimate);
      law "roots are compared by signs" (each signs);
      law "the lower root comes first" order;
      Law.law
        ~print:(Family.show Triangles.kind)
        "a polygon of three corners is a triangle" Triangles.whole.cases winding;
    ] )

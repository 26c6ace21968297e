(** Quadrics in exact arithmetic: the double coefficients of the form, its ends
    and its clip box, without any rounding of their own. *)

open Candor_space
open Candor_surface

type t = { form : Form.t; cuts : cut list }

(* The points x with n.(x - p) <= c. *)
and cut = { n : Dyadic_vec.t; p : Dyadic_vec.t; c : Dyadic.t; cap : int option }

let ends q =
  let between (first : Point.t) (second : Point.t) ~both =
    let n =
      Vec.sub (Point.sub second Point.origin) (Point.sub first Point.origin)
    in
    let c = (n.x *. n.x) +. (n.y *. n.y) +. (n.z *. n.z) in
    let cap k there = if Quadric.caps q && there then Some k else None in
    let p = Dyadic_vec.point first and n = Dyadic_vec.vec n in
    [
      { n; p; c = Dyadic.of_float c; cap = cap 1 true };
      { n = Dyadic_vec.neg n; p; c = Dyadic.zero; cap = cap 2 both };
    ]
  in
  match Quadric.shape q with
  | Cylinder { from; until; _ } -> between from until ~both:true
  | Cone { apex; base; _ } | Paraboloid { apex; base; _ } ->
      between apex base ~both:false
  | _ -> []

let zero = Dyadic_vec.of_floats 0. 0. 0.

let clip quadric =
  match Quadric.clip quadric with
  | None -> []
  | Some (b : Bounds.t) ->
      let face x y z c =
        if Float.is_finite c then
          let n = Dyadic_vec.of_floats x y z in
          [ { n; p = zero; c = Dyadic.of_float c; cap = None } ]
        else []
      in
      List.concat
        [
          face (-1.) 0. 0. (-.b.x0);
          face 1. 0. 0. b.x1;
          face 0. (-1.) 0. (-.b.y0);
          face 0. 1. 0. b.y1;
          face 0. 0. (-1.) (-.b.z0);
          face 0. 0. 1. b.z1;
        ]

let of_quadric q =
  { form = Form.of_shape (Quadric.shape q); cuts = ends q @ clip q }

(* {1 Along a line} *)

let times (f : Form.t) (a : Dyadic_vec.t) =
  let open Dyadic in
  let xy = of_float f.axy and xz = of_float f.axz and yz = of_float f.ayz in
  Dyadic_vec.v
    ((of_float f.axx * a.x) + (xy * a.y) + (xz * a.z))
    ((xy * a.x) + (of_float f.ayy * a.y) + (yz * a.z))
    ((xz * a.x) + (yz * a.y) + (of_float f.azz * a.z))

let center (f : Form.t) = Dyadic_vec.of_floats f.cx f.cy f.cz
let linear (f : Form.t) = Dyadic_vec.of_floats f.gx f.gy f.gz

(* a t² + 2 h t + c is weight² times F on the line. *)
let polynomial (f : Form.t) (line : Line.t) =
  let y = Line.from line (center f) and d = line.direction in
  let w = line.weight in
  let g = Dyadic_vec.scale w (linear f) in
  let ay = times f y in
  let k = Dyadic.(of_float f.k * w * w) in
  Dyadic_vec.(
    Exact_root.quadratic
      ( dot d (times f d),
        dot d (add ay g),
        Dyadic.(dot y (add (add ay g) g) + k) ))

(* The line is in the cut at t: v + t w <= 0. *)
let along cut (line : Line.t) =
  ( Dyadic.(Dyadic_vec.dot cut.n (Line.from line cut.p) - (cut.c * line.weight)),
    Dyadic_vec.dot cut.n line.direction )

let keeps line root cut =
  let v, w = along cut line in
  match Dyadic.sign w with
  | 0 -> Dyadic.sign v <= 0
  | s ->
      let n = if s > 0 then Dyadic.neg v else v in
      s * Exact_root.against root n (Dyadic.abs w) <= 0

let kept_by cuts line root = List.for_all (keeps line root) cuts

let surface { cuts; _ } line (p : Exact_root.quadratic) =
  let falls_first =
    match Dyadic.sign p.a with 0 -> Dyadic.sign p.h < 0 | s -> s > 0
  in
  let side falls : Side.t = if falls then Outside else Inside in
  List.mapi
    (fun i root ->
      { Crossing.at = root; side = side (falls_first = (i = 0)); part = 0 })
    (Exact_root.roots p)
  |> List.filter (fun (x : Crossing.t) -> kept_by cuts line x.at)

(* F at n/d on the line, times d². *)
let sign_at (p : Exact_root.quadratic) n d =
  Dyadic.(sign ((n * ((p.a * n) + shift 1 (p.h * d))) + (p.c * d * d)))

let disk { cuts; _ } line p cut =
  match (cut.cap, along cut line) with
  | None, _ -> None
  | Some _, (_, w) when Dyadic.sign w = 0 -> None
  | Some part, (v, w) ->
      let others = List.filter (fun other -> other != cut) cuts in
      let at = Exact_root.ratio (Dyadic.neg v) w in
      if sign_at p (Dyadic.neg v) w <= 0 && kept_by others line at then
        let side : Side.t = if Dyadic.sign w < 0 then Outside else Inside in
        Some { Crossing.at; side; part }
      else None

(* The sizes of the terms that cancel in the discriminant, the origin's own
   included. *)
let band (f : Form.t) (line : Line.t) (p : Exact_root.quadratic) =
  let open Wide in
  let y = Line.from line (center f) and d = line.direction in
  let size a = of_dyadic (Dyadic_vec.size a) in
  let w = of_dyadic line.weight in
  let d2 = Dyadic_vec.dot d d and yd = Dyadic_vec.dot y d in
  let closest =
    Dyadic_vec.(sub (scale d2 y) (scale yd d)) |> size |> fun s ->
    div s (of_dyadic d2)
  in
  let dm = size d and reach = add closest (size y) in
  let am = of_float f.a_size and gm = mul w (of_float f.g_size) in
  let a_size = mul am (mul dm dm) in
  let b_size = mul dm (add (mul am reach) gm) in
  let c_size =
    add
      (mul (add (mul am closest) (add gm gm)) reach)
      (mul (mul w w) (abs (of_float f.k)))
  in
  let tiny = v 1. (-96) in
  let a = abs (of_dyadic p.a) and h = abs (of_dyadic p.h) in
  leq a (mul tiny a_size)
  || leq
       (abs (of_dyadic p.discriminant))
       (mul tiny (add (mul h b_size) (add (mul a_size c_size) (mul a c_size))))

let slack (f : Form.t) (line : Line.t) =
  let far =
    Dyadic.(
      Dyadic_vec.size (Line.from line (center f))
      + (line.weight * Dyadic_vec.size (center f)))
  in
  let d = Dyadic_vec.largest line.direction in
  Wide.(div (of_dyadic (Dyadic.shift (-96) far)) (of_dyadic d))

let truth_along q line =
  let p = polynomial q.form line in
  {
    Crossing.crossings =
      surface q line p @ List.filter_map (disk q line p) q.cuts;
    band = lazy (band q.form line p);
    slack = Crossing.slack (slack q.form line);
  }

(** [truth q line] is where [line] crosses [q]. *)
let truth q line = truth_along q (Crossing.exact line)

(* {1 At a point} *)

open Exact

let image (f : Form.t) a =
  v
    ((q f.axx * a.x) + (q f.axy * a.y) + (q f.axz * a.z))
    ((q f.axy * a.x) + (q f.ayy * a.y) + (q f.ayz * a.z))
    ((q f.axz * a.x) + (q f.ayz * a.y) + (q f.azz * a.z))

let offset (f : Form.t) p = sub p (v (q f.cx) (q f.cy) (q f.cz))
let slope (f : Form.t) y = add (image f y) (v (q f.gx) (q f.gy) (q f.gz))

(** [value form p] is F at [p]. *)
let value (f : Form.t) p =
  let y = offset f p in
  dot y (add (slope f y) (v (q f.gx) (q f.gy) (q f.gz))) + q f.k

(** [gradient form p] is half the gradient of F at [p]. *)
let gradient f p = slope f (offset f p)

(** [equation form line] is (a, h, c) with a t² + 2 h t + c = F on [line]. *)
let equation (f : Form.t) { Crossing.origin; direction = d } =
  let y = offset f origin in
  (dot d (image f d), dot d (slope f y), value f origin)

(** [normal cut] is normal to [cut], towards what is cut off. *)
let normal { n; _ } = Dyadic.(v (to_q n.x) (to_q n.y) (to_q n.z))

(** [beyond cut p] is how far [p] is past [cut], in lengths of its normal. *)
let beyond ({ p = q; c; _ } as cut) p =
  let q = Dyadic.(v (to_q q.x) (to_q q.y) (to_q q.z)) in
  dot (normal cut) (sub p q) - Dyadic.to_q c

(** Quadrics in exact arithmetic: the double coefficients of the form, its ends
    and its clip box, without any rounding of their own. *)

open Candor_space
open Candor_surface
open Exact
open Crossing

type t = { form : Form.t; cuts : cut list }

(* The points x with n.(x - p) <= c. *)
and cut = { n : vec; p : vec; c : Q.t; cap : int option }

let ends q =
  let between (first : Point.t) (second : Point.t) ~both =
    let n =
      Vec.sub (Point.sub second Point.origin) (Point.sub first Point.origin)
    in
    let c = (n.x *. n.x) +. (n.y *. n.y) +. (n.z *. n.z) in
    let cap k there = if Quadric.caps q && there then Some k else None in
    let p = point first and n = vec n in
    [
      { n; p; c = Exact.q c; cap = cap 1 true };
      { n = scale (Q.of_int (-1)) n; p; c = zero; cap = cap 2 both };
    ]
  in
  match Quadric.shape q with
  | Cylinder { from; until; _ } -> between from until ~both:true
  | Cone { apex; base; _ } | Paraboloid { apex; base; _ } ->
      between apex base ~both:false
  | _ -> []

let clip quadric =
  match Quadric.clip quadric with
  | None -> []
  | Some (b : Bounds.t) ->
      let axis x y z c =
        let n = v (Q.of_int x) (Q.of_int y) (Q.of_int z) in
        { n; p = v zero zero zero; c = q c; cap = None }
      in
      List.filter
        (fun cut -> Q.is_real cut.c)
        [
          axis (-1) 0 0 (-.b.x0);
          axis 1 0 0 b.x1;
          axis 0 (-1) 0 (-.b.y0);
          axis 0 1 0 b.y1;
          axis 0 0 (-1) (-.b.z0);
          axis 0 0 1 b.z1;
        ]

let of_quadric q =
  { form = Form.of_shape (Quadric.shape q); cuts = ends q @ clip q }

let times (f : Form.t) a =
  v
    ((q f.axx * a.x) + (q f.axy * a.y) + (q f.axz * a.z))
    ((q f.axy * a.x) + (q f.ayy * a.y) + (q f.ayz * a.z))
    ((q f.axz * a.x) + (q f.ayz * a.y) + (q f.azz * a.z))

let offset (f : Form.t) p = sub p (v (q f.cx) (q f.cy) (q f.cz))
let slope (f : Form.t) y = add (times f y) (v (q f.gx) (q f.gy) (q f.gz))

(** [value form p] is F at [p]. *)
let value (f : Form.t) p =
  let y = offset f p in
  dot y (add (slope f y) (v (q f.gx) (q f.gy) (q f.gz))) + q f.k

(** [gradient form p] is half the gradient of F at [p]. *)
let gradient f p = slope f (offset f p)

let equation (f : Form.t) { origin; direction = d } =
  let y = offset f origin in
  (dot d (times f d), dot d (slope f y), value f origin)

(* The root is in the cut: v + t w <= 0. *)
let keeps { origin; direction = d } root cut =
  let v = dot cut.n (sub origin cut.p) - cut.c and w = dot cut.n d in
  match Q.sign w with
  | 0 -> Q.sign v <= 0
  | s -> Int.mul s (Exact_root.compare root (Q.neg v / w)) <= 0

let truth { form = f; cuts } line =
  let ((a, h, _) as abc) = equation f line in
  let kept_by cuts root = List.for_all (keeps line root) cuts in
  let surface =
    let falls_first = if Q.sign a <> 0 then Q.sign a > 0 else Q.sign h < 0 in
    let side falls : Side.t = if falls then Outside else Inside in
    List.mapi
      (fun i root ->
        { at = root; side = side (falls_first = (i = 0)); part = 0 })
      (Exact_root.of_quadratic abc)
    |> List.filter (fun x -> kept_by cuts x.at)
  in
  let disk cut =
    match (cut.cap, Q.sign (dot cut.n line.direction)) with
    | None, _ | _, 0 -> None
    | Some part, s ->
        let along = dot cut.n line.direction in
        let t = (cut.c - dot cut.n (sub line.origin cut.p)) / along in
        let p = Exact.along line.origin line.direction t in
        let others = List.filter (fun other -> other != cut) cuts in
        if Q.sign (value f p) <= 0 && kept_by others (Ratio t) then
          let side : Side.t = if s < 0 then Outside else Inside in
          Some { at = Ratio t; side; part }
        else None
  in
  let y = offset f line.origin and d = line.direction in
  let d2 = dot d d in
  let closest = add y (scale (Q.neg (dot y d) / d2) d) in
  (* The sizes of the terms that cancel in the discriminant, the origin's own
     included. *)
  let band =
    lazy
      (let dm = size d and pm = size closest and fm = size y in
       let am = q f.a_size and gm = q f.g_size in
       let a_size = am * dm * dm in
       let b_size = dm * ((am * (pm + fm)) + gm) in
       let c_size = (((am * pm) + (two * gm)) * (pm + fm)) + Q.abs (q f.k) in
       Q.leq (Q.abs a) (power (-96) * a_size)
       || Q.leq
            (Q.abs (Exact_root.discriminant abc))
            (power (-96)
            * ((Q.abs h * b_size) + (a_size * c_size) + (Q.abs a * c_size))))
  in
  let slack =
    let reach = size y + Q.abs (q f.cx) + Q.abs (q f.cy) + Q.abs (q f.cz) in
    power (-96) * reach / largest d
  in
  { crossings = surface @ List.filter_map disk cuts; band; slack }

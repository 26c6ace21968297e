open Candor_number
open Candor_space
open Piece

(* Whether F <= 0 where the ray crosses the plane of a cut: by its double at the
   rounded point unless that could be rounding, else exactly. *)
let on_disk q (ray : Object_ray.t) t cut =
  let o = ray.origin and d = ray.direction in
  let f = q.form in
  let p = Point.along o d t in
  let y = Point.sub p (Form.center f) in
  let g = Form.gradient f y in
  let value = Vec.dot g y +. Vec.dot (Form.slope f) y +. f.k in
  let reach = Vec.norm1 (Point.sub o (Form.center f)) +. (t *. Vec.norm1 d) in
  (* y is off by 8 ulp of t d and the roundings of p and y. *)
  let slope = (f.a_size *. reach) +. f.g_size in
  let doubt =
    (0x1p-46 *. ((slope *. reach) +. Float.abs f.k))
    +. (4. *. slope *. Vec.norm1 ray.origin_low)
  in
  if value < -.doubt then true
  else if value > doubt then false
  else
    let a, b, c = exact_equation q ray in
    let v, w = Half_space.along cut ray in
    let open Expansion in
    let ab = sub (mul a v) (mul b w) and bc = sub (mul b v) (mul c w) in
    (* w^2 F(-v/w) = v (a v - b w) - w (b v - c w) *)
    sign (sub (mul v ab) (mul w bc)) <= 0

let meet q ray end_ left cursor =
  let h = q.cuts.(end_) in
  let part = end_ + 1 in
  if (not (Contact.is_none left)) && Contact.part left = part then Contact.none
  else
    let across = Half_space.speed h ray in
    let t = Half_space.depth h ray /. across in
    if
      t > 0. && t <= cursor.Cursor.t && on_disk q ray t h
      && within_cuts q ray t (Of_cut end_) ~except:end_
    then
      Cursor.take cursor t
        (Contact.v ~part (if across < 0. then Outside else Inside))
    else Contact.none

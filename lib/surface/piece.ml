open Candor_number
open Candor_space

type t = {
  form : Form.t;
  linear : bool;
  cuts : Half_space.t array;
  disks : int array;
}

let make form ~cuts ~disks = { form; linear = Form.is_linear form; cuts; disks }

(* {1 Cutting} *)

let exact_equation q ray =
  Form.along_exactly q.form
    (Object_ray.from ray (Form.center q.form))
    (Object_ray.toward ray)

(* What t is a root of: F along the ray, or the plane of one of the cuts. *)
type solved = Of_form of { falling : bool } | Of_cut of int

let within_cuts q ray t solved ~except =
  let inside i h =
    i = except
    ||
    match Half_space.verdict h ray t with
    | Half_space.In -> true
    | Out -> false
    | Unsure -> (
        let cut = Half_space.along h ray in
        match solved with
        | Of_form { falling } ->
            Root.is_within (exact_equation q ray) ~falling cut
        | Of_cut k ->
            let v, w = Half_space.along q.cuts.(k) ray in
            let v', w' = cut in
            let open Expansion in
            (* v' + t w' <= 0 where t = -v/w *)
            sign w * sign (sub (mul v' w) (mul v w')) <= 0)
  in
  let rec all i =
    i = Array.length q.cuts || (inside i q.cuts.(i) && all (i + 1))
  in
  all 0

(* {1 Taking} *)

let contact_of_root b root =
  Contact.v ~part:0 (if Root.falls ~b root then Side.Outside else Inside)

let consider q ray t b root cursor =
  if
    t > 0. && t <= cursor.Cursor.t
    && within_cuts q ray t
         (Of_form { falling = Root.falls ~b root })
         ~except:(-1)
  then Cursor.take cursor t (contact_of_root b root)
  else Contact.none

let[@inline] later earlier last = if Contact.is_none last then earlier else last

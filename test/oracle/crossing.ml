(** Where a line meets a surface, exactly. *)

open Candor_space

type t = { at : Exact_root.t; side : Side.t; part : int }
(** [side] is where the line comes from. *)

type line = { origin : Exact.vec; direction : Exact.vec }

let line (r : Ray.t) =
  { origin = Exact.point r.origin; direction = Exact.vec r.direction }

type truth = { crossings : t list; band : bool Lazy.t; slack : Q.t }
(** What the surface lets pass: [band] is whether the decision is nearer to a
    tie than the library promises to see, [slack] how far a [t] may be off
    besides its ulps. *)

(** [exactly crossings] forgives nothing. *)
let exactly crossings = { crossings; band = lazy false; slack = Q.zero }

let too_far = Exact.power 1024
let too_near = Exact.power (-1075)

(** [first crossings] is the first at a t > 0 that doubles can tell from 0 and
    from infinity. Of two the earlier is the one that is not after the other's
    approximation to 250 bits. *)
let first crossings =
  let ahead =
    List.filter
      (fun c ->
        Exact_root.compare c.at too_near > 0
        && Exact_root.compare c.at too_far < 0)
      crossings
  in
  let earlier a b =
    if Exact_root.compare a.at (Exact_root.approximate b.at) <= 0 then a else b
  in
  match ahead with
  | [] -> None
  | c :: rest -> Some (List.fold_left earlier c rest)

type answer = { t : float; side : Side.t; part : int }

(** How a computed hit compares with the truth. Where several crossings are as
    near as t can tell, the side and part of any of them will do. *)
type verdict =
  | Agrees
  | Excused  (** different, but within what is forgiven *)
  | False_miss
  | False_hit
  | Wrong_t
  | Wrong_side  (** or part *)
  | Not_finite

(** [judge ~ulps truth answer] compares the library's [answer] with [truth];
    [ulps] is the error that t may have. *)
let judge ~ulps { crossings; band; slack } answer =
  let open Exact in
  let allowed t = (q ulps * q (ulp t)) + slack in
  let near (a : answer) (c : t) = Exact_root.near c.at (q a.t) (allowed a.t) in
  let same (a : answer) (c : t) = a.side = c.side && a.part = c.part in
  let forgiven verdict =
    let at_start (c : t) = Exact_root.near c.at zero slack in
    let lost_start = Q.sign slack > 0 && List.exists at_start crossings in
    if Lazy.force band then Excused
    else
      match (verdict, answer) with
      | (False_miss | False_hit), _ when lost_start -> Excused
      | Wrong_t, Some a when lost_start && List.exists (near a) crossings ->
          Excused
      | _ -> verdict
  in
  match (first crossings, answer) with
  | None, None -> Agrees
  | _, Some { t; _ } when not (Float.is_finite t) -> Not_finite
  | Some c, Some a ->
      if not (near a c) then forgiven Wrong_t
      else if List.exists (fun c -> near a c && same a c) crossings then Agrees
      else forgiven Wrong_side
  | None, Some _ -> forgiven False_hit
  | Some _, None -> forgiven False_miss

(** [error truth answer] is the error of t in ulps, less the slack; [None] if
    there is nothing to compare. *)
let error { crossings; slack; _ } answer =
  let open Exact in
  match (first crossings, answer) with
  | Some c, Some (a : answer) ->
      let t = Exact_root.approximate c.at in
      let off = Q.max zero (Q.abs (q a.t - t) - slack) in
      Some (Q.to_float (off / q (ulp (Q.to_float t))))
  | _ -> None

let show_verdict = function
  | Agrees -> "agrees"
  | Excused -> "is excused"
  | False_miss -> "false miss"
  | False_hit -> "false hit"
  | Wrong_t -> "wrong t"
  | Wrong_side -> "wrong side or part"
  | Not_finite -> "a t that is not finite"

(** Where a line meets a surface, exactly. *)

open Candor_space

type t = { at : Exact_root.t; side : Side.t; part : int }
(** [side] is where the line comes from. *)

type line = { origin : Exact.vec; direction : Exact.vec }

let line (r : Ray.t) =
  { origin = Exact.point r.origin; direction = Exact.vec r.direction }

(** [exact line] is [line] as the oracles see it. *)
let exact { origin; direction } = Line.of_rationals origin direction

type truth = { crossings : t list; band : bool Lazy.t; slack : Dyadic.t }
(** What the surface lets pass: [band] is whether the decision is nearer to a
    tie than the library promises to see, [slack] how far a [t] may be off
    besides its ulps. *)

(** [exactly crossings] forgives nothing. *)
let exactly crossings = { crossings; band = lazy false; slack = Dyadic.zero }

(** [slack wide] is [wide] as a number to forgive. *)
let slack wide = Wide.to_dyadic wide

(* Whether doubles can tell a t > 0 from 0 and from infinity. *)
let in_range c =
  Exact_root.sign c.at > 0
  &&
  let { Wide.e; _ } = Exact_root.estimate c.at in
  let beyond k = Exact_root.against c.at (Dyadic.power k) Dyadic.one in
  (e > -1000 || beyond (-1075) > 0) && (e < 1000 || beyond 1024 < 0)

(** [first crossings] is the first at a t > 0 that doubles can tell from 0 and
    from infinity. *)
let first crossings =
  let earlier a b = if Exact_root.before a.at b.at then a else b in
  match List.filter in_range crossings with
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

(* The distance is known to 2^-48: only where that leaves a doubt are exact signs
   asked for. *)
let near ~ulps slack (a : answer) (c : t) =
  let x = Dyadic.of_float a.t and ulp = Exact.ulp a.t in
  let off = Exact_root.distance c.at x in
  let few = Wide.of_float (ulps *. ulp *. (1. -. 0x1p-40)) in
  Wide.leq off few
  ||
  let allowed = Dyadic.((of_float ulps * of_float ulp) + slack) in
  Exact_root.near c.at x allowed

(** [judge ~ulps truth answer] compares the library's [answer] with [truth];
    [ulps] is the error that t may have, in ulps of the answer. *)
let judge ~ulps { crossings; band; slack } answer =
  let near = near ~ulps slack in
  let same (a : answer) (c : t) = a.side = c.side && a.part = c.part in
  let forgiven verdict =
    let at_start (c : t) = Exact_root.near c.at Dyadic.zero slack in
    let lost_start = Dyadic.sign slack > 0 && List.exists at_start crossings in
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
      else if same a c || List.exists (fun c -> near a c && same a c) crossings
      then Agrees
      else forgiven Wrong_side
  | None, Some _ -> forgiven False_hit
  | Some _, None -> forgiven False_miss

(** [error truth answer] is the error of t in ulps of the answer, less the
    slack; [None] if there is nothing to compare. *)
let error { crossings; slack; _ } answer =
  match (first crossings, answer) with
  | Some c, Some (a : answer) ->
      let off = Exact_root.distance c.at (Dyadic.of_float a.t) in
      let off = Wide.(sub off (of_dyadic slack)) in
      let ulps = Wide.(div off (of_float (Exact.ulp a.t))) in
      Some (Float.max 0. (Wide.to_float ulps))
  | _ -> None

let show_verdict = function
  | Agrees -> "agrees"
  | Excused -> "is excused"
  | False_miss -> "false miss"
  | False_hit -> "false hit"
  | Wrong_t -> "wrong t"
  | Wrong_side -> "wrong side or part"
  | Not_finite -> "a t that is not finite"

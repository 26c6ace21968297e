(** Boxes in exact arithmetic: closed slabs. *)

open Candor_space
open Exact
open Crossing

(* When and through which part the line enters and leaves the slab lo..hi;
   [None] for never and always. *)
type passage = Never | Always | From of (Q.t * int) * (Q.t * int)

let slab axis lo hi o d =
  let low = Int.mul 2 axis in
  let high = succ low in
  match Q.sign d with
  | 0 -> if Q.leq lo o && Q.leq o hi then Always else Never
  | s ->
      let at face = (face - o) / d in
      if s > 0 then From ((at lo, low), (at hi, high))
      else From ((at hi, high), (at lo, low))

(* The faces met so close to [t] that doubles cannot tell them apart. *)
let parts_at t passages =
  let near (t', _) = Q.leq (Q.abs (t' - t)) (power (-51) * Q.abs t) in
  List.map snd (List.filter near passages)

let truth (b : Candor_surface.Box.t) { origin = o; direction = d } =
  let b = (b :> Bounds.t) in
  let slabs =
    [
      slab 0 (q b.x0) (q b.x1) o.x d.x;
      slab 1 (q b.y0) (q b.y1) o.y d.y;
      slab 2 (q b.z0) (q b.z1) o.z d.z;
    ]
  in
  let never = List.exists (function Never -> true | _ -> false) slabs in
  let within =
    List.filter_map (function From (e, l) -> Some (e, l) | _ -> None) slabs
  in
  let entries = List.map fst within and exits = List.map snd within in
  let most keep = function
    | [] -> None
    | (t, _) :: rest -> Some (List.fold_left (fun m (t, _) -> keep m t) t rest)
  in
  match (most Q.max entries, most Q.min exits) with
  | Some near, Some far when (not never) && Q.leq near far ->
      let at side t part = { at = Exact_root.Ratio t; side; part } in
      exactly
        (List.map (at Side.Outside near) (parts_at near entries)
        @ List.map (at Side.Inside far) (parts_at far exits))
  | _ -> exactly []

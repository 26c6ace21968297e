open Candor_colour
open Candor_sample

type t =
  | Fixed of { depth : int; cutoff : float }
  | Roulette of { depth : int }
  | At_once

(* Not inlined, so that [survival] is, whose result then needs no box. *)
let[@inline never] cut tally (path : Path.t) weight (cut : Event.cut) =
  Tally.count tally
    (match cut with Depth -> Cut_by_depth | Weight -> Cut_by_weight);
  Tally.leave_out tally ~carried:path.throughput weight;
  if Tally.watched tally then Tally.show tally (Cut cut)

(* Below this depth paths end only where they would multiply. *)
let sure = 5
let most = 0.95

let chance (path : Path.t) ~weight ~beside =
  let w = Rgb.largest weight and other = Rgb.largest beside in
  let share = if other > 0. then w /. (w +. other) else 1. in
  if path.depth < sure then share
  else
    let carried = Rgb.largest (Rgb.mul path.throughput weight) in
    share *. Float.min most carried

let roulette (path : Path.t) branch ~weight ~beside =
  let chance = chance path ~weight ~beside in
  let of_branch = { path with key = Key.below path.key branch } in
  if chance >= 1. then 1.
  else if Path.one of_branch Survival < chance then 1. /. chance
  else 0.

let survival limit tally (path : Path.t) branch ~weight ~beside =
  if Rgb.is_black weight then 0.
  else
    match limit with
    | At_once -> 0.
    | Fixed { depth; cutoff } ->
        if path.depth >= depth then (
          cut tally path weight Depth;
          0.)
        else if Rgb.largest (Rgb.mul path.throughput weight) < cutoff then (
          cut tally path weight Weight;
          0.)
        else 1.
    | Roulette { depth } ->
        if path.depth >= depth then (
          cut tally path weight Depth;
          0.)
        else roulette path branch ~weight ~beside

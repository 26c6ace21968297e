(** How many cases went which way, and how far the answers were off: of a fixed
    size, however many cases there are. *)

type t = {
  mutable cases : int;
  mutable hits : int;  (** those that were compared *)
  mutable false_misses : int;
  mutable false_hits : int;
  mutable wrong_sides : int;
  mutable wrong_ts : int;
  mutable not_finite : int;
  mutable excused : int;
  mutable greatest : float;  (** error *)
  errors : int array;  (** by steps of 1/{!steps}; the last holds the rest *)
}

let steps = 16
let most = 64

let make () =
  {
    cases = 0;
    hits = 0;
    false_misses = 0;
    false_hits = 0;
    wrong_sides = 0;
    wrong_ts = 0;
    not_finite = 0;
    excused = 0;
    greatest = 0.;
    errors = Array.make ((steps * most) + 1) 0;
  }

(** [error tally e] counts an error of [e >= 0]. *)
let error tally e =
  let step =
    Float.min (e *. float_of_int steps) (float_of_int (steps * most))
  in
  let i = int_of_float step in
  tally.hits <- tally.hits + 1;
  tally.errors.(i) <- tally.errors.(i) + 1;
  tally.greatest <- Float.max tally.greatest e

(** [verdict tally v] counts a case. *)
let verdict tally (v : Crossing.verdict) =
  tally.cases <- tally.cases + 1;
  match v with
  | Agrees -> ()
  | Excused -> tally.excused <- tally.excused + 1
  | False_miss -> tally.false_misses <- tally.false_misses + 1
  | False_hit -> tally.false_hits <- tally.false_hits + 1
  | Wrong_t -> tally.wrong_ts <- tally.wrong_ts + 1
  | Wrong_side -> tally.wrong_sides <- tally.wrong_sides + 1
  | Not_finite -> tally.not_finite <- tally.not_finite + 1

(** [quantile tally p] is an error that a share of at least [p] of the hits stay
    below, at most a step too large. *)
let quantile tally p =
  let wanted = Float.to_int (Float.ceil (p *. float_of_int tally.hits)) in
  let rec go i below =
    let below = below + tally.errors.(i) in
    if below >= wanted then
      Float.min tally.greatest (float_of_int (i + 1) /. float_of_int steps)
    else go (i + 1) below
  in
  if tally.hits = 0 then nan else go 0 0

(** [wrong tally] is how many cases went wrong. *)
let wrong t =
  t.false_misses + t.false_hits + t.wrong_sides + t.wrong_ts + t.not_finite

(** [heading] is what the columns of {!row} are. *)
let heading =
  Printf.sprintf "%8s %8s %5s %5s %5s %5s %5s %6s %6s %6s %6s %7s" "cases"
    "hits" "miss-" "hit-" "side-" "t-" "nan" "excus" "p50" "p99" "p99.9"
    "max ulp"

let row t =
  Printf.sprintf "%8d %8d %5d %5d %5d %5d %5d %6d %6.2f %6.2f %6.2f %7.3g"
    t.cases t.hits t.false_misses t.false_hits t.wrong_sides t.wrong_ts
    t.not_finite t.excused (quantile t 0.5) (quantile t 0.99) (quantile t 0.999)
    t.greatest

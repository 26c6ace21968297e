(** Logarithmic axes, total: every number has its place, or is known to have
    none. *)

type t
(** An axis: numbers from a lowest to a highest, both positive and finite, drawn
    from one coordinate to another by their logarithms. *)

(** Where a number stands on an axis. *)
type place =
  | At of float  (** the coordinate *)
  | Below  (** less than the lowest: also 0 and all that is negative *)
  | Above  (** more than the highest, perhaps infinite *)
  | Nowhere  (** not a number *)

val v : from:float -> into:float -> margin:float -> float list -> t
(** [v ~from ~into ~margin values] is the axis that holds what is positive and
    finite of [values], times or divided by [margin > 1]; from 0.1 to 10 if
    there is no such value. Its lowest number is drawn at [from] and its highest
    at [into]. *)

val place : t -> float -> place

val clamped : t -> float -> float option
(** [clamped s x] is the coordinate of [x], or of the end of the axis next to
    it; [None] for [nan]. *)

val power : t -> (float -> float) -> float * float
(** [power s f] is [f] of the natural logarithms of the ends of [s], lowest
    first: what a power law, a line in logarithms, is drawn from. *)

val log_coordinate : t -> float -> float
(** [log_coordinate s l] is where e^[l] would stand on [s] if that went on for
    ever; finite, at most ten times the axis' length away, and the lowest end
    for [nan]. *)

val decades : t -> float list
(** [decades s] are round numbers on [s], ascending: 1, 2 and 5 times powers of
    ten where these are few, else powers of ten, evenly thinned out; at most
    about 12. *)

val times : t -> float list
(** [times s] are round seconds on [s]: {!decades} below a minute, then minutes
    and hours. *)

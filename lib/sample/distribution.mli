(** Distributions that are constant by pieces, made from weights.

    Only the ratios of weights count. Weights are meant to be finite and not
    negative; negative ones and [nan] count as 0. *)

type t
(** Which of n things to take: each with a probability in proportion to its
    weight. *)

type choice = {
  index : int;  (** which of the things, from 0; never one of weight 0 *)
  rest : float;  (** what is left of [u] for other uses, uniform in \[0;1\[ *)
  probability : float;  (** with which the thing is taken *)
}

val make : floatarray -> t option
(** [make weights] is the distribution over the indices of [weights]; [None] if
    no weight is positive or one is infinite. *)

val length : t -> int
(** [length t] is the number of weights. *)

val probability : t -> int -> float
(** [probability t i] is that of [i], right to the last bits; 0 outside 0 …
    length − 1. *)

val sample : t -> float -> choice
(** [sample t u] is the choice that uniform [u] in \[0;1\[ makes: growing with
    [u], in logarithmic time. *)

(** {1 Rectangles} *)

type square
(** A density on the unit square, constant in each cell of a grid. *)

type place = {
  u : float;  (** across, in \[0;1\[ *)
  v : float;  (** down the rows, in \[0;1\[ *)
  density : float;  (** per area of the unit square *)
}

val square : columns:int -> floatarray -> square option
(** [square ~columns weights] is the density in proportion to [weights], which
    are those of the cells row by row, [columns ≥ 1] to a row; cells that are
    missing from the last row weigh 0. [None] as for {!make}. *)

val place : square -> Pattern.position -> place
(** [place s p] takes uniform [p] in \[0;1\[² to a place of density [density s].
*)

val density : square -> Pattern.position -> float
(** [density s p] is the density at [p]; 0 outside the unit square. *)

(** Rows of a price list beside each other. *)

val is_knee : Price.t -> Price.row -> bool

val base : Price.t -> Price.row -> Price.row option
(** [base p r] is the rung of [p]'s ladder with the samples of [r]: what [r]
    changes. *)

val saving : Price.t -> Price.row -> float option
(** [saving p r] is the share of its base's seconds that [r] saves; negative if
    it takes longer. [None] without a base, or where that is no finite number.
*)

val per_halving : Price.t -> (Price.row * float option) list
(** [per_halving p] is the ladder, each rung with the seconds that half the
    error costs on the way from the rung before: the seconds between them over
    the logarithm to base 2 of the ratio of their errors, where that is finite
    and positive. *)

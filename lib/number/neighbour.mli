(** Doubles next to a double, without asking for its bits.

    After S. M. Rump, P. Zimmermann, S. Boldo, G. Melquiond,
    {e Computing Predecessor and Successor in Rounding to Nearest}, BIT
    Numerical Mathematics 49(2), 2009. *)

val succ : float -> float
(** [succ x] is [Float.succ x]. *)

val pred : float -> float
(** [pred x] is [Float.pred x]. *)

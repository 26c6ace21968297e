(** Time that may be spent. *)

type t

val start : float -> t
(** [start seconds] begins to spend [seconds] > 0. Measurements may take most of
    it; a little is kept back for what comes after. *)

val whole : t -> float
(** [whole b] is all of it. *)

val spent : t -> float
(** [spent b] is the seconds since [b] began. *)

val left : t -> float
(** [left b] is the seconds until measurements must stop, at least 0. *)

(** How far a query still has to look, and what it has done: the one mutable
    value of an intersection query. It is born and dies inside the query, so
    nobody can observe it. *)

type t = private {
  mutable t : float;  (** hits at least < t' ≤ [t] are of interest *)
  least : float;  (** 0; more for the textbook's formulas *)
  time : float;  (** when the ray is cast: where moving surfaces stand *)
  mutable tests : float;  (** how many surfaces were tested *)
  mutable careful : float;  (** in how many tests plain doubles did not do *)
  mutable last : float;  (** which test that was last; -1 if there is none *)
}

val v : ?least:float -> ?time:float -> float -> t
(** [v limit] is a cursor at [limit], with [least] and [time] 0 unless given. *)

val take : t -> float -> Contact.t -> Contact.t
(** [take cursor t contact] is [contact], with [cursor] moved to [t], if
    cursor.least < t ≤ cursor.t and [t] is finite; else {!Contact.none}. *)

val tested : t -> unit
(** [tested cursor] counts a test. *)

val careful : t -> unit
(** [careful cursor] counts the test under way as one that needed more than
    plain doubles, once. *)

(** How far a query still has to look: the one mutable value of an intersection
    query. It is born and dies inside the query, so nobody can observe it. *)

type t = { mutable t : float }
(** Hits at 0 < t' ≤ [t] are of interest; a kernel that finds one moves [t]
    there. *)

val take : t -> float -> Contact.t -> Contact.t
(** [take cursor t contact] is [contact], with [cursor] moved to [t], if 0 < t ≤
    cursor.t and [t] is finite; else {!Contact.none}. *)

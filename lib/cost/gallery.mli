(** Pictures of a price list: of the pixels that were measured. *)

val rungs : Price.t -> Markup.t
(** [rungs p] is the picture of every rung beside its errors. *)

val maps : Price.t -> Markup.t
(** [maps p] is where time goes, and where adaptive samples would. *)

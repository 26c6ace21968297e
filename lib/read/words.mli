(** Words that readers of more than one kind of form must know. *)

val top_level : string list
(** [top_level] is the heads of the forms that stand in [(scene ...)]. *)

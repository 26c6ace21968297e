(** What the design promises and this version does not do yet: refused, never
    ignored. *)

val options : unit Cmdliner.Term.t
(** [options] fails on the options of [render] that are still to come. *)

val commands : Status.t Cmdliner.Cmd.t list
(** [commands] are commands that say that they are still to come. *)

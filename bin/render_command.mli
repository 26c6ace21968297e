(** [candor render]. *)

val command : Status.t Cmdliner.Cmd.t

(** [candor check]. *)

val command : Status.t Cmdliner.Cmd.t

(** [candor explain]. *)

val command : Status.t Cmdliner.Cmd.t

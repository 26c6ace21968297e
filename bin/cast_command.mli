(** [candor cast]. *)

val command : Status.t Cmdliner.Cmd.t

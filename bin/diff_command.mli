(** [candor diff]. *)

val command : Status.t Cmdliner.Cmd.t

(** [candor cost]. *)

val command : Status.t Cmdliner.Cmd.t

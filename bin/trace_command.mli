(** [candor trace]. *)

val command : Status.t Cmdliner.Cmd.t

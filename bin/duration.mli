(** Times as users write them. *)

val conv : float Cmdliner.Arg.conv
(** [conv] reads [20s], [1.5m] or [1h] (seconds, minutes, hours; a number alone
    is seconds), more than 0 and finite, as seconds. *)

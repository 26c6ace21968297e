(** Seconds of wall-clock time. *)

type t

val start : unit -> t
(** [start ()] is a clock that starts now. *)

val seconds : t -> float
(** [seconds c] is how long ago [c] started. It never goes back. *)

val of_program : unit -> float
(** [of_program ()] is how long ago the program started. *)

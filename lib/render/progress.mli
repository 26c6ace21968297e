(** Tells people how far a render is. *)

type t

val make : quiet:bool -> t
(** [make ~quiet] speaks on standard error: a bar that is redrawn on a terminal,
    a plain line every few seconds elsewhere, nothing at all if [quiet]. *)

val report : t -> Pace.t -> unit
(** [report p pace] says how much is done, and how much time is left, from where
    to where, if the rest goes like it. Any domain may call it. *)

val finish : t -> unit
(** [finish p] clears the bar. *)

val time : float -> string
(** [time s] is [s] seconds in words as short as [3.4 s] or [5 min 12 s]. *)

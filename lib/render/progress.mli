(** Tells people how far a render is. *)

type t

val make : quiet:bool -> t
(** [make ~quiet] speaks on standard error: a bar that is redrawn on a terminal,
    a plain line every few seconds elsewhere, nothing at all if [quiet]. *)

val report : t -> float -> unit
(** [report p share] says that [share] (in \[0;1\]) is done, and how much time
    is left if the rest goes like it. Any domain may call it. *)

val finish : t -> unit
(** [finish p] clears the bar. *)

val time : float -> string
(** [time s] is [s] seconds in words as short as [3.4 s] or [5 min 12 s]. *)

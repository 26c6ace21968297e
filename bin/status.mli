(** Exit codes, and how commands end. *)

type t =
  | Fine
  | Wrong of string  (** the scene, an input or an output is wrong *)
  | Reported  (** likewise, and the user has been told already *)
  | Usage of string  (** the command line asks for what cannot be *)
  | Missed of string  (** a stated target was not met *)
  | Interrupted of string

val code : t -> int
(** [code s] tells the user what [s] says, on standard error, and is the exit
    code: 0, 1, 1, 2, 3 or 130. *)

val tell : string -> unit
(** [tell text] writes [text] and a newline to standard error; nothing happens
    if that is closed or full. *)

val infos : Cmdliner.Cmd.Exit.info list
(** [infos] is the same for help pages. *)

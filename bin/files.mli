(** What commands that write files have in common. *)

open Candor_render

val stop_on_signals : unit -> unit -> bool
(** [stop_on_signals ()] is whether a signal has asked the program to end; from
    here on none kills it, so that files are left as they were. *)

val writing :
  string -> (Output.t -> ('a, Status.t) result) -> ('a, Status.t) result
(** [writing name f] is [f file], with [file] about to be written as [name].
    Unless that ends well, for whatever reason, nothing is left of [file]. *)

val writing_some :
  string option ->
  ((string Lazy.t -> (unit, Status.t) result) -> ('a, Status.t) result) ->
  ('a, Status.t) result
(** [writing_some name f] is [f write], where [write text] writes the file
    [name], if there is one to write; else nobody asks for [text]. *)

val wrong : ('a, string) result -> ('a, Status.t) result
(** [wrong r] is [r], its error being what is wrong with an output. *)

val read : string -> (string, string) result
(** [read name] is what is in the file [name]; the error names it, too. *)

(** What the rows of a price list are called. *)

open Candor_scene

val setting : Price.setting -> string
(** [setting s] is a row's name, such as [16 samples] or
    [without spot light, line 12]. *)

val line : Place.t -> string
(** [line p] is [, line 12], or nothing where no file says. *)

val worth : float -> bool
(** [worth share] is whether a share of time is worth saving: a hundredth. *)

val key : int -> string
(** [key i] is the mark of the [i]th of the other settings, in plot and table:
    [a] to [z], then [a1] to [z1] and so on. *)

val verdict : Price.row -> string option
(** [verdict r] is what is to be said of [r]; nothing of a rung. *)

val places : Price.setting -> (string * Place.t) list
(** [places s] are the words of the scene that call for what [s] leaves out, and
    where they stand, as far as a file says. *)

val rms : float -> string
(** [rms e] is an error with its unit, such as [0.71/255]. *)

(** Which parts of a picture go on, and which are good enough, as the samples of
    others say.

    A {!Part} is judged by its {!Part.judges}. When they show an error that is
    small enough for the whole picture ({!Sampling.cautious}), or that more
    samples are in vain, it stops, and stays as it is then: also if it takes
    more samples, because others still ask what they say. *)

type t
(** What was decided so far. *)

val fewest : int
(** [fewest] is how many pixels are enough to judge each other. In smaller
    windows all parts judge all, and stop together. *)

val start : Window.t -> t
(** [start window] is that all parts go on that the window has. *)

val is_done : t -> bool
(** [is_done j] is [true] iff no part goes on. *)

val all_met : t -> bool
(** [all_met j] is [true] iff all parts stopped because their judges saw an
    error that is small enough. *)

val is_needed : t -> int -> bool
(** [is_needed j part] is whether samples of [part] have a say in what is still
    going on: its own, or of a part that it judges. *)

val sampling : Row.t array -> Sampling.t
(** [sampling rows] is what all samples say of the error of all pixels. *)

val judge :
  error:float option ->
  confidence:float ->
  full:bool array ->
  Row.t array ->
  t ->
  t
(** [judge ~error ~confidence ~full rows j] is [j] after the parts were judged
    by what the window's [rows] say: those stop whose [error] is met, if there
    is one, with that confidence; those that are [full], which is that no more
    samples are to be had; and, if an error was asked for, those of whose judges
    a pixel tells nothing, for it never will. *)

val results : Row.t array -> t -> Row.result array
(** [results rows j] is the picture: the pixels of parts that stopped as they
    were then, all others as they are. *)

(** What is to be said of a setting beside the rung that it changes. *)

type t = { loss : float; verdict : Price.verdict }

val v :
  Price.setting ->
  law:Power_law.t option ->
  finest:Pair.t ->
  base:Pair.t ->
  Pair.t ->
  share:float ->
  saved:float ->
  t
(** [v setting ~law ~finest ~base p ~share ~saved] is what the picture loses
    under [p] beside [base], and the verdict on [setting], which saves [saved]
    of the time (negative if it takes more), measured on [share] of all pixels.

    A light or an effect is paid for nothing if every pixel of the subset has
    the same bits without it, or if {!Pair.change} finds no difference and
    excludes, with a confidence of .95, any that shows: of half a level in the
    root mean square. Where no such difference is lost a setting saves its time;
    a light or an effect only if that is a hundredth at least and noise does not
    grow: else they are needed. A sampler loses nothing in the mean: its loss is
    the change of the error, and it saves the time that the law of errors says
    it does at equal error, if the change of noise is beyond chance. *)

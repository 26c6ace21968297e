(** What can be measured of a scene within a budget.

    Every setting is measured on one subset of the pixels, with two independent
    sets of samples. First comes the ladder: 1 sample a pixel (at its centre),
    2, 4, 8, … and the scene's own number, as far as the budget goes with a part
    kept for the rest; the finest rung stands for the truth. Then every other
    setting is measured at the scene's own samples, or the most below that for
    which time is left, with the same random numbers as that rung, so that
    differences between pictures are not noise. *)

open Candor_scene

type request = {
  scene : Scene.t;
  domains : int;
  budget : Budget.t;
  stop : unit -> bool;  (** whether the user wants it to end *)
  progress : float -> unit;  (** is told the share of the budget spent *)
}

type rung = { spp : int; pair : Pair.t }

type other = {
  variant : Variant.t;
  changed : Pair.t;
  ratio : float;
      (** of its time to that of the rung, which was measured again in between,
          so that whatever slows the machine for a while slows both *)
}

type t = {
  subset : Subset.t;
  rungs : rung list;  (** fewest samples first; at least one *)
  base : rung option;  (** what the others are to be put beside *)
  others : other list;
  missing : Variant.t list;  (** settings for which there was no time *)
}

val finest : t -> rung
(** [finest s] is the rung of most samples. *)

val run : request -> t option
(** [run r] is what was measured: if need be one sample of one pixel, even
    beyond the budget. [None] if [stop] answered [true]. *)

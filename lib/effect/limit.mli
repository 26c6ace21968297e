(** When paths end. *)

open Candor_colour

type t =
  | Fixed of { depth : int; cutoff : float }
      (** at [depth] steps, and where the largest component of the throughput
          falls below [cutoff]: what is cut adds nothing, and is counted *)
  | Roulette of { depth : int }
      (** at [depth] steps, and by chance: what goes on in spite of that counts
          the more, so that nothing is lost in the mean. After J. Arvo, D. Kirk,
          {e Particle Transport and Image Synthesis}, 1990. *)
  | At_once  (** before the first step: the picture has none of this kind *)

val survival :
  t ->
  Tally.t ->
  Path.t ->
  Candor_sample.Key.purpose ->
  weight:Rgb.t ->
  beside:Rgb.t ->
  float
(** [survival l tally p branch ~weight ~beside] is what to multiply the light by
    that [p] finds by the step [branch] of throughput [weight]: 0 if it ends, at
    least 1 otherwise. Steps of black throughput end, and are not counted;
    others that [l] cuts are, with their throughput ({!Tally.leave_out}).
    [beside] is the throughput of what else follows from the same surface: steps
    that compete for the light of one path share its chances, so that paths do
    not multiply. *)

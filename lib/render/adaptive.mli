(** Samples where they lower the error of the displayed picture most, until it
    is small enough or time is up.

    The number of samples that are shared out climbs a ladder whose rungs no
    sample has a say in: four a pixel, and then more by 2{^ 1/8} each. At first
    nearly all go to all pixels alike, from eight a pixel on a quarter to a half
    of them; the others go where {!Allocation} says. A {!Part} stops at the
    first rung at which its judges' pixels, as they stand there, show an error
    that is small enough for the whole picture ({!Sampling.cautious}), or a
    sample that is not finite, or all that may have more have the most. It stays
    as it is then; others may go on for a while. Where there is no time for four
    samples of each pixel, the last of them go to some parts only, and if not
    even for one, the other pixels have none ({!Stand_in}).

    Without an error to meet, the samples that all pixels have are doubled while
    that is expected to cost at most 15 % of the error that the time allows; the
    rest of the time goes where {!Allocation} says.

    {b Law.} Without [left], and with {!Jury.fewest} pixels or more, the mean of
    such pictures, over seeds, is the mean of all samples: how many a pixel has
    is a function of the samples of other parts. For shares, a part asks its
    advisers what they showed when all pixels had the same number; for the end,
    its judges, none of which asks it for shares. (With [left], the clock has a
    say, and it knows what samples cost.) *)

type target = {
  error : float option;
      (** the greatest RMS error, in units of 1/255, with this confidence: *)
  confidence : float;  (** in \]0, 1\[ *)
  left : (unit -> float) option;
      (** how many seconds may still be spent, if they are counted *)
  most : int;  (** samples per pixel, at least 1 *)
}

(** Why it ended. *)
type ending =
  | Met  (** the error is met *)
  | Misjudged
      (** all judges said so, but by what the pixels say together their error is
          likely larger *)
  | Out_of_time
  | Out_of_samples
      (** all pixels that seem to have an error have the most, or a sample is
          not finite *)

type outcome = {
  results : Row.result array;
  ending : ending;
  forecasts : Forecast.t list;  (** first to last *)
}

val run :
  Window.t ->
  Row.t array ->
  target ->
  pass:((int -> int -> int) -> unit option) ->
  expect:(Forecast.t -> unit) ->
  outcome option
(** [run window rows target ~pass ~expect] takes samples of [rows], which are
    the window's and have none. [pass f] gives each pixel (x, y) its first
    [f x y] samples, or is [None] if it was stopped; so is the outcome. [expect]
    is told each forecast. Without [left] all is a function of the scene and the
    target. *)

(** Samples where they lower the error of the displayed picture most, until it
    is small enough or time is up.

    First all pixels are given the same number of samples, a share of those that
    the target is going to need. They tell, once, how the others are given out:
    see {!Allocation}. If in the end the target is missed by a little, all
    shares grow alike. *)

type target = {
  error : float option;
      (** the greatest RMS error, in units of 1/255, with this confidence: *)
  confidence : float;  (** in \]0, 1\[ *)
  left : (unit -> float) option;
      (** how many seconds may still be spent, if they are counted *)
  most : int;  (** samples per pixel, at least 1 *)
}

type forecast = {
  taken : float;  (** samples that the whole picture had when it was made *)
  total : float;  (** that it is going to have *)
  low : float;
  high : float;  (** with 95 % confidence between these *)
}

(** Why it ended. *)
type ending =
  | Met  (** the error is met *)
  | Out_of_time
  | Out_of_samples  (** all pixels that seem to have an error have the most *)

type outcome = {
  results : Row.result array;
  ending : ending;
  forecasts : forecast list;  (** first to last *)
}

val run :
  Row.t array ->
  target ->
  pass:((int -> int -> int) -> Row.result array option) ->
  expect:(forecast -> unit) ->
  outcome option
(** [run rows target ~pass ~expect] takes samples of [rows], which have none.
    [pass f] gives pixel (x, y) of them [f x y] samples and says what they say
    then, or is [None] if it was stopped; so is the outcome. [expect] is told
    each forecast. Without [left] all is a function of the scene and the target.
*)

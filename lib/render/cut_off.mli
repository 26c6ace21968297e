(** What a picture may have lost where paths were cut.

    A path that is cut would have found a radiance between 0 and the scene's
    greatest, and had the weight of its throughput. So a pixel that shows x, its
    mean over samples, would show between x and x + w·L with no path cut, w
    being the mean weight of what was cut in it and L a bound by {!Brightest}.
    On display it has lost g(x + w·L) − g(x) at most, g being {!Display.encode}.
    That is proved of the samples that were taken, in the mean over how paths
    would have gone on from where they were cut; the rest is sampling error. *)

open Candor_colour
open Candor_scene
open Candor_effect
open Candor_image

type t =
  | At_most of float
      (** the RMS error over pixels and colours of what is displayed, before
          8-bit rounding, in units of 1/255 *)
  | Unbounded of string  (** no bound is known, and why *)
[@@deriving show, eq]

val squares : most:Rgb.t -> cut:Rgb.t -> Rgb.t -> float
(** [squares ~most ~cut mean] is the sum, over the three colours, of the squares
    of what a pixel of radiance [mean] may have lost, in (1/255)², where paths
    find [most] at most and those cut had the mean weight [cut]. What is not a
    number counts as all of the display's range. *)

val of_squares : pixels:int -> float -> t
(** [of_squares ~pixels s] is the bound for [pixels ≥ 1] pixels whose {!squares}
    add up to [s]. *)

val of_picture : Brightest.t -> cut:Picture.t -> Picture.t -> t
(** [of_picture brightest ~cut p] is the bound for the picture [p], [cut] being
    the mean weight of what was cut in each of its pixels: {!Tally.left_out}
    over the number of samples. *)

(** {1 In the ledger} *)

val text : Scene.t -> Tally.t -> t Lazy.t -> string
(** [text scene tally bound] is the ledger's line: the bound, rounded up, and
    how many paths were cut by what, or why there is none; [bound] is asked only
    if [tally] counted some. *)

val json : Tally.t -> t Lazy.t -> Json.t
(** [json tally bound] is the same for programs. ["rms"] is the bound in units
    of 1/255: 0 where nothing was cut, null where it is unbounded, with a
    ["reason"]. *)

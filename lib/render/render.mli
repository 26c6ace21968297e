(** Renders a scene: rows in parallel, the same bits for any number of domains.
*)

open Candor_scene
open Candor_effect
open Candor_trace
open Candor_image

(** How many samples the pixels are given. *)
type samples =
  | Uniform of int  (** each so many, at least 1 *)
  | Map of Sample_map.t
      (** as it says; it contains the window. Pixels with none show their
          {!Stand_in}. *)
  | Adaptive of Adaptive.target

type aim = {
  target : Adaptive.target;
  ending : Adaptive.ending;
  forecasts : Forecast.t list;
}
(** How an adaptive render went. *)

type report = {
  picture : Picture.t;
  window : Window.t;
  map : Sample_map.t;
      (** the samples that the picture is made of: an adaptive render may have
          taken more. It is of the window, and beyond where that shows the
          {!Stand_in} of a pixel without samples. *)
  sampling : Sampling.t;  (** what they say of their error *)
  cut_off : Cut_off.t Lazy.t;
      (** what may be lost where paths were cut; for one domain to ask *)
  aim : aim option;  (** of an [Adaptive] render *)
  seconds : float;  (** wall-clock time from the first ray to the last *)
  domains : int;
  tally : Tally.t;
  words : float;  (** allocated in the minor heaps while tracing *)
  non_finite_pixel : (int * int) option;
      (** the first pixel that is infinite or not a number *)
}

val run :
  ?domains:int ->
  ?stop:(unit -> bool) ->
  ?progress:(Pace.t -> unit) ->
  ?window:Window.t ->
  ?samples:samples ->
  Pixel.t ->
  Scene.t ->
  report option
(** [run p s] renders [window] (default: all) of [s], compiled as [p], with
    [samples] (default: [Uniform] as [s] says). [progress] is told how far it is
    after each row, from whichever domain did it. [None] if [stop] answered
    [true] before the end. {b Law.} [Map (r.map)] renders the picture of report
    [r] again, to the bit, in the same window. *)

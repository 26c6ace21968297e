(** Renders a scene: rows in parallel, the same bits for any number of domains.
*)

open Candor_scene
open Candor_effect
open Candor_trace
open Candor_image

type window = { x0 : int; y0 : int; x1 : int; y1 : int }
(** The pixels x0 ≤ x < x1, y0 ≤ y < y1 of the full picture. *)

val full : Scene.t -> window
(** [full s] is all of [s]'s picture. *)

type report = {
  picture : Picture.t;
  window : window;
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
  ?progress:(float -> unit) ->
  ?window:window ->
  Pixel.t ->
  Scene.t ->
  report option
(** [run p s] renders [window] (default: all) of [s], compiled as [p].
    [progress] is told the share of rows done after each, from whichever domain
    did it. [None] if [stop] answered [true] before the end. *)

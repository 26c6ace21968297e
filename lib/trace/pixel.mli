(** The pixels of a scene's picture. *)

open Candor_space
open Candor_colour
open Candor_scene
open Candor_surface
open Candor_optics
open Candor_effect

type t
(** A scene made ready to render: surfaces, plan, camera and samples. It is
    immutable; any number of domains may share it. *)

val compile :
  ?plan:Plan.t ->
  ?math:Candor_surface.Math.t ->
  ?sampler:Candor_sample.Sampler.t ->
  Scene.t ->
  t
(** [compile s] assembles [s] under [plan] (default: [Plan.of_scene s]), its
    surfaces met by [math] (default [Stable]), its random numbers shared out by
    [sampler] (default [Sobol]). *)

val surface : t -> Skin.t Surface.t
(** [surface p] is all of the scene's surfaces. *)

val plan : t -> Plan.t

val ray : t -> x:int -> y:int -> sample:int -> Ray.t
(** [ray p ~x ~y ~sample] is the camera ray of that sample. *)

val sample : t -> Tally.t -> x:int -> y:int -> sample:int -> Rgb.t
(** [sample p tally ~x ~y ~sample] is the radiance that one sample finds, a pure
    function of the scene and these numbers. *)

val radiance : t -> Tally.t -> x:int -> y:int -> Rgb.t
(** [radiance p tally ~x ~y] is the mean of the pixel's samples. Samples that
    are not finite are counted in [tally] and make the mean so: nothing hides
    them. *)

(** {1 Sums of samples} *)

val slots : int
(** [slots] is how many numbers hold the sums of a pixel's samples: for each of
    {!Candor_sample.Sampler.streams} streams a {!Candor_number.Running_sum} of
    red, green and blue, two slots each. *)

val add :
  t ->
  Tally.t ->
  x:int ->
  y:int ->
  from:int ->
  until:int ->
  floatarray ->
  int ->
  unit
(** [add p tally ~x ~y ~from ~until sums i] adds samples [from] … [until − 1] of
    the pixel (x, y) to the {!slots} of [sums] from [i] on, each to the sums of
    its stream. However a range is parted, its sums have the same bits. There
    are samples past those of the scene's settings. *)

val mean : floatarray -> int -> samples:int -> Rgb.t
(** [mean sums i ~samples] is the mean of the first [samples] ≥ 1 samples of a
    pixel, whose sums are in [sums] from [i] on. *)

val stream_sum :
  floatarray -> int -> stream:int -> channel:int -> Candor_number.Running_sum.t
(** [stream_sum sums i ~stream ~channel] is the sum of one of its streams in one
    channel: 0 red, 1 green, 2 blue. *)

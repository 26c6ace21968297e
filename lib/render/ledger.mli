(** What a render says about itself when it is done. *)

open Candor_scene
open Candor_image

type output = {
  clamped : int;  (** pixels with a channel above what the display can show *)
  rounding : float;
      (** the RMS error that 8-bit rounding adds, in units of 1/255 *)
}

val output : Picture.t -> output
(** [output p] is what an 8-bit file of [p] loses. *)

val text :
  name:string ->
  format:Picture_file.format ->
  confidence:float ->
  ?warnings:string list ->
  Scene.t ->
  Render.report ->
  string
(** [text ~name ~format ~confidence ~warnings scene report] is the ledger: a
    headline for the picture [name], then a line each for the errors of
    sampling, cut-off, numerics and output, and for each of [warnings]. A bound
    stands there only where it is proved; else [unknown] or [unbounded], and
    why. *)

val json :
  confidence:float -> Scene.t -> Candor_effect.Plan.t -> Render.report -> Json.t
(** [json ~confidence scene plan report] is the same for programs, with every
    counter. *)

(** What accuracy costs in one scene: the price list. *)

open Candor_scene
open Candor_effect
open Candor_image

(** What a row changes. *)
type setting =
  | Samples of int  (** per pixel *)
  | Depth of int
  | Cutoff of float
  | Sampler of Candor_sample.Sampler.t
  | Without_light of { name : string; place : Place.t }
      (** a light of [(light ...)], an area light, or the background or ambient
          light *)
  | Without_effect of { absent : Effect.t; reasons : Reason.t list }
  | Naive_math

type measure = {
  seconds : float;  (** for the whole picture, from the first ray to the last *)
  rays_per_pixel : float;
  rms : float;
      (** error of the displayed picture beside the finest rung, whose own noise
          is taken off, in units of 1/255 *)
  p99 : float;  (** the 99th percentile of pixels' errors, likewise *)
}

type verdict =
  | Rung  (** of the ladder of samples *)
  | Needed
  | Saves of float  (** the share of time that it saves at no loss that shows *)
  | Paid_for_nothing  (** costs time, changes nothing *)
  | Wrong_pixels of int  (** naive math: in the whole picture, as estimated *)

type row = {
  setting : setting;
  spp : int;  (** at which the row was measured *)
  measure : measure;
  loss : float;
      (** what the picture loses beside the row's base, rms, 1/255; 0 for rungs
      *)
  pareto : bool;
  verdict : verdict;
}

type law = { a : float; b : float; scatter : float }
(** error ≈ a·t^−b, rms in 1/255 and seconds of the whole picture; [scatter] is
    the standard deviation of ln error about it. *)

type prediction = {
  error : float;
  seconds : float;
  low : float;
  high : float;
  spp : int;
}
(** [error] takes [seconds], with 95 % confidence from [low] to [high]. *)

type view = { spp : int; picture : Picture.t; error : Plane.t }
(** A rung of the ladder, a pixel for each of the subset: its picture and each
    pixel's error in 1/255. *)

type t = {
  scene : string;  (** file name *)
  width : int;
  height : int;
  domains : int;
  pixels : int;  (** measured *)
  budget : float;  (** seconds *)
  spent : float;
  ladder : row list;  (** by samples, fewest first *)
  knee : row option;
  others : row list;  (** every other setting *)
  law : law option;
  predictions : prediction list;  (** for errors 4, 2, 1 and 1/2 *)
  views : view list;
  time : Plane.t;  (** seconds per sample of each pixel of the subset *)
  samples : Plane.t;
      (** samples per pixel that adaptive sampling would give them, mean 1 *)
}

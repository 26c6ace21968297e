(** What the pixels of a subset look like, and how long they take. *)

open Candor_trace
open Candor_image

type t = {
  picture : Picture.t;  (** of the subset *)
  linear : floatarray;
      (** red, green and blue of each pixel in turn, full brightness being 255
      *)
  shown : floatarray;
      (** the same as displayed: red, green and blue of each pixel in turn, in
          units of 1/255, before rounding *)
  times : floatarray;  (** seconds for each pixel *)
  seconds : float;
      (** for the whole picture, if its pixels are like these, all domains are
          busy and other programs take nothing away *)
  rays_per_pixel : float;
}

val run : domains:int -> stop:(unit -> bool) -> Subset.t -> Pixel.t -> t option
(** [run ~domains ~stop subset scene] renders [subset] of [scene]. [None] if
    [stop] answered [true] before the end. *)

(** The rays that a camera sends through its picture. *)

open Candor_space
open Candor_scene

val compile : Camera.t -> width:int -> height:int -> float -> float -> Ray.t
(** [compile c ~width ~height x y] is the ray through the place (x, y) of the
    picture, counted in pixels from its top left corner: pixel (i, j) has its
    centre at (i + .5, j + .5). [t] counts distance along the line of sight: the
    direction's component along it is 1. Directions are built without the eye's
    coordinates, so a camera far from the origin sees as well as one near it. *)

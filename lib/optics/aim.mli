(** The rays that a camera sends through its picture. *)

open Candor_space
open Candor_scene

val compile : Camera.t -> width:int -> height:int -> float -> float -> Ray.t
(** [compile c ~width ~height x y] is the ray through the place (x, y) of the
    picture, counted in pixels from its top left corner: pixel (i, j) has its
    centre at (i + .5, j + .5). [t] counts distance along the line of sight: the
    direction's component along it is 1. Directions are built without the eye's
    coordinates, so a camera far from the origin sees as well as one near it. *)

val compile_lens :
  Camera.t ->
  Camera.lens ->
  width:int ->
  height:int ->
  float ->
  float ->
  Candor_sample.Pattern.position ->
  Ray.t
(** [compile_lens c lens ~width ~height x y p] is the ray through that place of
    the picture from the point of a thin lens that uniform [p] takes: what lies
    in the plane at distance [lens.focus] along the view is met where the ray
    through the middle meets it. A radius of 0 gives the rays of {!compile};
    cameras without perspective have no lens. After R. L. Cook, T. Porter, L.
    Carpenter, {e Distributed Ray Tracing}, 1984. *)

type view = { left : float; right : float; top : float; bottom : float }
(** A part of the picture, in pixels from its top left corner. *)

val sight : Camera.t -> width:int -> height:int -> Bounds.t -> view option
(** [sight c ~width ~height b] is where points of [b] may be seen, up to
    rounding, by cameras whose picture is flat and that have no lens; [None] if
    that is not known: for other cameras, for bounds that are not finite, and
    for those that reach to the eye or behind it. *)

(** Anti-aliasing: pixels are the mean of several samples, where one does not
    decide them. *)

open Candor_scene
open Candor_optics

val name : string
val meaning : string

val calls : Scene.t -> Reason.t list
(** [calls s] is the number of samples, if it is more than one and there is
    something to see. *)

type decided = x:int -> y:int -> bool
(** Whether one sample decides the pixel (x, y): all others would be equal to
    it, bit for bit. *)

val none : decided
(** [none] decides no pixel. *)

val background : Scene.t -> Skin.t Candor_surface.Surface.t -> decided
(** [background s surface] decides pixels in which nothing can be seen but a
    uniform background: the boxes around the surfaces are seen elsewhere, by
    more than the samples spread and doubles round. The camera must have a flat
    picture and no lens, and there must be no fog. *)

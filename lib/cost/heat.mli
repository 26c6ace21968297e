(** Numbers of pixels as colours, and what the colours mean. *)

open Candor_image

type t
(** From numbers to the colours of {!Candor_image.Magma}. *)

val errors : t
(** Errors in units of 1/255, by doublings from ¼ (black, as is less) to 64
    (pale, as is more): the same for all pictures, so that pages compare. *)

val shares : t
(** Multiples of a mean, by doublings from ⅛ to 8. *)

val seconds : Plane.t -> t
(** [seconds p] is evenly from 0 to what 99 % of the numbers of [p] do not
    exceed. *)

val map : t -> Plane.t -> Picture.t
(** [map h p] is [p] in colours; what is not a number is black. *)

val legend : t -> Markup.t
(** [legend h] is a strip of all colours, with their numbers below. *)

val image : says:string -> Picture.t -> Markup.t
(** [image ~says p] is [p] in the page, within the page. *)

val marks : (float * string) list -> Markup.t
(** [marks all] are texts under something wide, each at its share of the width.
*)

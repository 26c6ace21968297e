(** The kernels of {!Flip}: how vision blurs colours, and finds edges and
    points, seen at a number of pixels per degree of visual angle. All are one
    row of an odd number of weights, for {!Plane.across}; two of them make a
    kernel for an area. *)

(** {1 Contrast sensitivity}

    What the eye does not resolve is blurred away: kernels that, run along rows
    and along columns and added up, have weights that sum to 1. After G. M.
    Johnson, M. D. Fairchild,
    {e A Top Down Description of S-CIELAB and CIEDE2000}, 2003. *)

val achromatic : ppd:float -> floatarray list
val red_green : ppd:float -> floatarray list
val blue_yellow : ppd:float -> floatarray list

(** {1 Features} *)

val smooth : ppd:float -> floatarray
(** A Gaussian whose weights sum to 1. *)

val edge : ppd:float -> floatarray
(** Its first derivative; what is positive sums to 1 and what is negative to −1.
*)

val point : ppd:float -> floatarray
(** Its second derivative, likewise. *)

val reach : ppd:float -> int
(** [reach ~ppd] is how many pixels away the widest of these kernels looks. *)

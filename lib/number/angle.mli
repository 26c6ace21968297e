(** Angles as users write them: in degrees. *)

val radians : float -> float
(** [radians a] is the angle of [a] degrees in radians. *)

val cos : float -> float
(** [cos a] is the cosine of [a] degrees; exact at multiples of 90, so that
    quarter turns are made of zeros and ones. *)

val sin : float -> float
(** [sin a] is the sine of [a] degrees; exact at multiples of 90. *)

val tan : float -> float
(** [tan a] is the tangent of [a] degrees; exact at multiples of 45 up to its
    poles. *)

(** Linear RGB: the only colour space that light is computed in.

    A value is a triple of non-negative doubles, one for each primary of sRGB
    (Rec. 709, D65). The unit depends on what the triple measures: radiance in
    W/(m² sr), irradiance in W/m², intensity in W/sr, or a plain ratio in
    \[0;1\] for an albedo. *)

type t = { r : float; g : float; b : float } [@@deriving show, eq, ord]

val v : float -> float -> float -> t
(** [v r g b] is the colour with these three components. *)

val grey : float -> t
(** [grey k] is [v k k k]. *)

val black : t
(** [black] is [grey 0.], the identity of {!add}. *)

val white : t
(** [white] is [grey 1.], the identity of {!mul}. *)

val add : t -> t -> t
(** [add a b] is the sum, component by component. *)

val mul : t -> t -> t
(** [mul a b] is the product, component by component. *)

val scale : float -> t -> t
(** [scale k c] is [mul (grey k) c]. *)

val is_black : t -> bool
(** [is_black c] is [true] iff all three components are zero. *)

val is_finite : t -> bool
(** [is_finite c] is [true] iff no component is infinite or not a number. *)

val greater : t -> t -> t
(** [greater a b] is the greater of both, component by component. *)

val largest : t -> float
(** [largest c] is the greatest component. *)

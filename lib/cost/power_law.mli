(** Power laws through points, y ≈ a·x^−b: least squares in the logarithms. *)

type t = {
  a : float;
  b : float;
  scatter : float;
      (** the standard deviation of ln y about the law, ∞ from two points *)
  points : int;
  centre : float;  (** the mean of ln x *)
  width : float;  (** the sum of squares of ln x about it *)
}

val fit : (float * float) list -> t option
(** [fit points] is the law through those points (x, y) that are positive and
    finite both ways; [None] unless there are two of different x. *)

val at : t -> float -> float
(** [at law x] is a·x^−b. *)

type estimate = { best : float; low : float; high : float }

val inverse : t -> float -> estimate option
(** [inverse law y] is the x at which y is met, with 95 % confidence between
    [low] and [high]: a further point's scatter and the uncertainty of the line,
    through its slope (N. R. Draper, H. Smith, {e Applied Regression Analysis},
    1966, on inverse regression). From two points that is from 0 to ∞. [None]
    where y does not fall as x grows, or [y] is not positive. *)

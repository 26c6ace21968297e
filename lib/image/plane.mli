(** One number for every pixel of a rectangle. *)

type t
(** Rows from the top, columns from the left; at least one pixel each way. *)

val init : width:int -> height:int -> (int -> float) -> t
(** [init ~width ~height f] is the plane whose number in column [x] and row [y]
    is [f (y * width + x)]. Raises [Invalid_argument] unless [width] and
    [height] are at least 1, and so does {!init3}. *)

val init3 :
  width:int -> height:int -> (int -> int -> float * float * float) -> t * t * t
(** [init3 ~width ~height f] is three planes at once: their numbers in column
    [x] and row [y] are [f x y]. *)

val width : t -> int
val height : t -> int

val get : t -> int -> float
(** [get p (y * width p + x)] is the number in column [x] and row [y]. Raises
    [Invalid_argument] outside the plane. *)

val add : t -> t -> t
(** [add p q] is the sum, pixel by pixel. Raises [Invalid_argument] when the
    sizes differ. *)

val across : floatarray -> t -> t
(** [across kernel p] is [p] with every row weighted by [kernel],
    {e transposed}: its number in column [y] and row [x] is the sum over [k] of
    [kernel.(k)] times the number of [p] in row [y] and column [x + k − r],
    where the kernel has [2 r + 1] weights. Pixels beyond the edge are like the
    last before it. So [across v (across h p)] is upright again, with [h] run
    along its rows and [v] along its columns. Raises [Invalid_argument] for an
    even number of weights. *)

val rows : first:int -> count:int -> t -> t
(** [rows ~first ~count p] is these rows of [p]. Raises [Invalid_argument] when
    it lacks one, or [count < 1]. *)

val stack : t list -> t
(** [stack ps] is the planes below each other, the first at the top. Raises
    [Invalid_argument] unless there is one and all are as wide. *)

val mean : t -> float
(** [mean p] is the mean of all numbers. *)

(** Where randomness comes from: pure functions of what a number is for.

    A key names one random number by the pixel, the sample, the bounce and the
    purpose that it serves. Nothing depends on the order in which numbers are
    asked for, so leaving an effect out changes no other number. *)

type purpose = Film  (** where in the pixel a sample is taken *)
[@@deriving show, eq, ord]

type t = private int
(** A well-mixed integer. *)

val v : seed:int -> x:int -> y:int -> sample:int -> bounce:int -> purpose -> t
(** [v ~seed ~x ~y ~sample ~bounce p] is the key of these. The pixel (x, y) is
    counted in the full picture, whatever part of it is rendered. *)

val derive : t -> int -> t
(** [derive k i] is the [i]-th key below [k]. *)

val float : t -> float
(** [float k] is a number in \[0;1\[, uniform over keys, a multiple of 2^-53. *)

val permute : t -> length:int -> int -> int
(** [permute k ~length i] is where a permutation of 0 … length−1 chosen by [k]
    takes [i]. Total for 0 ≤ i < length. *)

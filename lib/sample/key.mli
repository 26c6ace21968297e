(** Where randomness comes from: pure functions of what a number is for.

    A key names one random number by the pixel, the sample, the bounce and the
    purpose that it serves. Nothing depends on the order in which numbers are
    asked for, so leaving an effect out changes no other number. *)

type purpose =
  | Film  (** where in the pixel a sample is taken *)
  | Path  (** all that follows of a light path *)
  | Lens  (** where on the lens it starts *)
  | Shutter  (** when *)
  | Emitter  (** which area light is asked *)
  | Emitter_direction  (** where on it *)
  | Sky_direction  (** which part of the sky is asked *)
  | Lobe  (** which of the ways a surface scatters light *)
  | Bounce  (** where to *)
  | Survival  (** whether a path goes on *)
  | Reflected  (** what is reflected *)
  | Transmitted  (** what goes through *)
  | Boundary  (** which of both *)
  | Wavelength
  | Distance  (** how far light goes in a medium *)
  | Deflection  (** where it is scattered to *)
  | Share  (** which pixels have more samples than others *)
[@@deriving show, eq, ord]

type t = private int
(** A well-mixed integer. *)

val v : seed:int -> x:int -> y:int -> sample:int -> bounce:int -> purpose -> t
(** [v ~seed ~x ~y ~sample ~bounce p] is the key of these. The pixel (x, y) is
    counted in the full picture, whatever part of it is rendered. *)

val below : t -> purpose -> t
(** [below k p] is the key for [p] below [k]. *)

val derive : t -> int -> t
(** [derive k i] is the [i]-th key below [k]. *)

val float : t -> float
(** [float k] is a number in \[0;1\[, uniform over keys, a multiple of 2^-53. *)

val permute : t -> length:int -> int -> int
(** [permute k ~length i] is where a permutation of 0 … length−1 chosen by [k]
    takes [i]. Total for 0 ≤ i < length. *)

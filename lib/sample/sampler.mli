(** How the samples of a pixel share its random numbers out.

    Whatever the sampler, the samples s of a pixel fall into {!streams} streams,
    s mod {!streams}, that have nothing to do with each other: each draws from
    keys of its own. So the spread of their means tells the error of the whole
    without bias, although the samples within one stream depend on each other.
    Such batches are those of A. B. Owen,
    {e Monte Carlo Variance of Scrambled Net Quadrature}, SIAM Journal on
    Numerical Analysis 34(5), 1997. *)

type t =
  | Independent  (** every sample has its own numbers *)
  | Stratified
      (** as [Independent], but the places in the pixel of one stream are
          stratified: {!Pattern} *)
  | Sobol
      (** the numbers of each purpose fill their space evenly within a stream:
          {!Sobol} *)
[@@deriving show, eq, ord]

val all : t list
(** [all] is each sampler once. *)

val name : t -> string
(** [name s] is a word for [s]. *)

val streams : int
(** [streams] is 4, the least that tells an error and how far to trust that. The
    more streams, the less evenly do all samples together fill their space. *)

val stream : t -> int -> int
(** [stream s sample] names the keys of sample [sample] ≥ 0; those of samples
    that differ mod {!streams} differ. *)

val index : t -> int -> int
(** [index s sample] is which point of its keys the sample takes. *)

val film : t -> seed:int -> spp:int -> x:int -> y:int -> int -> Pattern.position
(** [film s ~seed ~spp] is where each of the [spp] samples of pixel (x, y) is in
    it. The one sample of [spp = 1] is at the exact centre; of more each by
    itself is uniform in the pixel. *)

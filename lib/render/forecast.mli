(** How many samples a picture is going to need. *)

type t = {
  taken : float;  (** samples that the whole picture had when it was made *)
  total : float;  (** that it is going to have *)
  low : float;
  high : float;  (** with 95 % confidence between these *)
}

val for_error : law:float option -> Sampling.t -> taken:float -> float -> t
(** [for_error ~law s ~taken total] is of a picture whose error, of which its
    [taken] samples say [s], is to come down to a target that they expect after
    [total] samples. [law] is the exponent by which they found the mean square
    error to fall with the number of samples, if they did. *)

val for_time : Sampling.t -> taken:float -> float -> t
(** [for_time s ~taken total] is of one that has time for [total] samples, if
    those to come take as long as those that were. *)

(** Orthonormal frames around one direction. *)

type t = { u : Dir.t; v : Dir.t; w : Dir.t }
(** Three unit directions at right angles, right-handed: u × v = w. *)

val of_dir : Dir.t -> t
(** [of_dir w] is a frame whose third axis is [w], continuous except across the
    plane z = 0. After T. Duff et al.,
    {e Building an Orthonormal Basis, Revisited}, JCGT 6(1), 2017. *)

(** Rays, which remember the surface that they leave. *)

type departure =
  | Nowhere  (** starts in empty space *)
  | Surface of { path : int list; part : int; side : Side.t }
      (** starts on a surface: which one (its place in the scene, from the top
          level down), which part of it (a face of a box, a cap of a quadric)
          and the side that the ray leaves on *)
[@@deriving show, eq, ord]

type t = { origin : Point.t; direction : Vec.t; departure : departure }
[@@deriving show, eq, ord]
(** The points [origin + t·direction] for t > 0. The direction need not have
    length 1; t counts in units of it. *)

val v : Point.t -> Vec.t -> t
(** [v p d] is the ray from [p] along [d] that starts [Nowhere]. *)

val at : t -> float -> Point.t
(** [at r t] is the point at [t], each coordinate rounded once. *)

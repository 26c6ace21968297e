(** Rays, which remember the surface that they leave. *)

type departure =
  | Nowhere  (** starts in empty space *)
  | Surface of { path : int list; part : int; side : Side.t }
      (** starts on a surface: which one (its place in the scene, from the top
          level down), which part of it (a face of a box, a cap of a quadric)
          and the side that the ray leaves on *)
[@@deriving show, eq, ord]

type t = {
  origin : Point.t;
  direction : Vec.t;
  direction_low : Vec.t;
      (** what doubles do not hold of the direction; zero unless made by
          {!toward} *)
  departure : departure;
}
[@@deriving show, eq, ord]
(** The points origin + t·(direction + direction_low) for t > 0. The direction
    need not have length 1; t counts in units of it. *)

val v : Point.t -> Vec.t -> t
(** [v p d] is the ray from [p] along [d] that starts [Nowhere]. *)

val leaving : departure -> Point.t -> Vec.t -> t
(** [leaving s p d] is the ray from [p] along [d] that starts on [s]. *)

val toward : Point.t -> t -> t
(** [toward p r] is the ray that starts as [r] does and is at [p], exactly, at t
    = 1. *)

val at : t -> float -> Point.t
(** [at r t] is the point at [t], each coordinate rounded once. *)

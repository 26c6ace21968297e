(** The ways to write a quadric down. *)

open Candor_space

type t =
  | Matrix of float array
      (** 16 numbers of a symmetric Q row by row: F = xᵀQx with x = (x y z 1) *)
  | Form of { a : float array; b : Vec.t; c : float }
      (** 9 numbers of a symmetric A row by row: F = xᵀAx − 2bᵀx + c *)
  | Plane of { normal : Vec.t; offset : float }
      (** normal·x = offset, the normal as written *)
  | Ellipsoid of { center : Point.t; radii : Vec.t }
  | Cylinder of { from : Point.t; until : Point.t; radius : float }
  | Cone of { apex : Point.t; base : Point.t; radius : float }
      (** one nappe; the radius is that at the base *)
  | Paraboloid of { apex : Point.t; base : Point.t; radius : float }
      (** the radius is that at the base *)
  | Hyperbolic_paraboloid of { center : Point.t; radii : Vec.t }
      (** x²/a² − y²/b² − z/c *)
  | Hyperboloid_one_sheet of { center : Point.t; radii : Vec.t }
      (** x²/a² + y²/b² − z²/c² − 1 *)
  | Hyperboloid_two_sheets of { center : Point.t; radii : Vec.t }
      (** x²/a² + y²/b² − z²/c² + 1 *)
[@@deriving show, eq, ord]

val check : t -> (unit, string) result
(** [check s] is [Error why] for an asymmetric matrix, radii that are not
    positive, an axis of no length, a zero normal, or numbers beyond 2^±400 (F's
    constant term: 2^800). *)

type ends = { first : Point.t; second : Point.t; radius : float }

val ends : t -> ends option
(** [ends s] is where the axis of a cylinder, cone or paraboloid begins and
    ends, and the radius there (for the latter two, at the second end). *)

val bounds : t -> Bounds.t
(** [bounds s] is a box that holds [s], cut at its ends; not finite where [s] is
    unbounded. *)

(** The two sides of a surface. *)

type t =
  | Outside
      (** where F > 0 for sphere, box and quadric; for a triangle the side on
          which its corners run counter-clockwise *)
  | Inside  (** the other one *)
[@@deriving show, eq, ord]

val opposite : t -> t
(** [opposite s] is the other side. *)

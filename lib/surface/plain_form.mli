(** Where rays meet the zero set of a {!Piece}, in plain doubles as long as
    proven bounds on their errors allow, else by {!Careful_form}.

    Two tiers of plain doubles: the school formula with coarse bounds, then the
    same equation about the point of the ray where F has its extremum, where the
    discriminant hardly cancels, with bounds term by term. *)

open Candor_space

val meet : Piece.t -> Object_ray.t -> Cursor.t -> Contact.t
(** [meet q ray cursor] is the first contact within [cursor], which moves there.
*)

val meet_again : Piece.t -> Object_ray.t -> Side.t -> Cursor.t -> Contact.t
(** [meet_again q ray side cursor] is the same for a ray that starts on the zero
    set and leaves it on [side]: the root at 0 is taken out of the equation. *)

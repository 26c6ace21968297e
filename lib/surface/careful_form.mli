(** Where rays meet the zero set of a {!Piece} when plain doubles do not tell:
    everything in twice the precision. Decisions are right unless the
    discriminant is within 2^-96 of the terms that it is made of. *)

open Candor_space

val meet : Piece.t -> Object_ray.t -> Cursor.t -> Contact.t
(** [meet q ray cursor] is the first contact within [cursor], which moves there.
*)

val meet_again : Piece.t -> Object_ray.t -> Side.t -> Cursor.t -> Contact.t
(** [meet_again q ray side cursor] is the same for a ray that starts on the zero
    set and leaves it on [side]: the root at 0 is taken out of the equation. *)

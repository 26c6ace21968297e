(** By which formulas surfaces are met. *)

type t =
  | Stable  (** Candor's: exact decisions, errors of some ulps *)
  | Textbook  (** as lectures write them: see {!Textbook} *)
[@@deriving show, eq, ord]

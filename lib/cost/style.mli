(** How the page looks. *)

val css : string
(** Styles for screens wide and narrow, light and dark, and for paper. Without
    resources, and without a character that HTML escapes. *)

(** The price list as a table of the page. *)

val v : Price.t -> Markup.t
(** [v p] has a line for every rung, and below one for every other setting, as
    its difference from the rung with as many samples. *)

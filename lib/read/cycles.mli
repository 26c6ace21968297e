(** Names that are defined by themselves. *)

val all : (string * string list) list -> string list list
(** [all edges] is one way around each cycle that is met when each name leads to
    the names in its list: [["a"; "b"; "a"]]. Names without an edge of their own
    lead nowhere. Takes time linear in [edges] but for a logarithm. *)

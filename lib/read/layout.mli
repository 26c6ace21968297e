(** S-expressions on lines of 80 columns. *)

type t
(** An s-expression that knows how wide it is. *)

val atom : string -> t
(** [atom s] is the word [s], in quotes where it would not read as one. *)

val list : t list -> t
(** [list l] is [(l...)]. *)

val form : string -> t list -> t
(** [form head body] is [(head body...)]. *)

val add : Buffer.t -> indent:int -> t -> unit
(** [add b ~indent s] appends [s] to [b], on one line if it fits behind [indent]
    spaces, and else with each list in it on a line of its own, two columns
    further in. Deep in, it stops moving to the right. Takes time linear in the
    size of [s]. *)

(** What each light and each effect of a scene costs, and what it gives. *)

val bars : Price.t -> Markup.t
(** [bars p] is a line for each light and each effect, dearest first: a bar for
    the share of time that leaving it out saves, and one for what the picture
    loses, in units of 1/255 on a logarithmic axis. *)

val nothing : Price.t -> Markup.t
(** [nothing p] lists what is paid for nothing, with its places in the scene. *)

val savings : Price.t -> Markup.t option
(** [savings p] lists settings that save time at no loss that shows, if any. *)

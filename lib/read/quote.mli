(** Words of a scene in the midst of a message. *)

val brief : string -> string
(** [brief s] is [s] on one line of at most 40 printable bytes. *)

val word : string -> string
(** [word s] is [brief s] in backquotes. *)

val list : string list -> string
(** [list ["a"; "b"; "c"]] is ["a, b or c"]. *)

val count : int -> string -> string
(** [count n "number"] is ["1 number"], ["2 numbers"] and so on. *)

val chain : string list -> string
(** [chain names] is how one leads to the next; of many only the first eight. *)

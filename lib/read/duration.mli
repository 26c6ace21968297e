(** Times as people write them. *)

val of_string : string -> (float, string) result
(** [of_string s] reads [20s], [1.5m] or [1h] (seconds, minutes, hours; a number
    alone is seconds), above 0 and finite, as seconds. The error says what was
    expected. *)

val to_string : float -> string
(** [to_string t] is [t] seconds, so that {!of_string} reads the same. *)

(** Numbers as scenes write them. *)

val of_string : string -> (float, string) result
(** [of_string s] is the double nearest to the decimal number [s], such as [2],
    [-.5] or [1e3], or exactly the hexadecimal one, such as [0x1.8p3].
    [Error why] for anything else, [nan] and infinities included, and for
    numbers too large for a double. *)

val is_meant : string -> bool
(** [is_meant s] is [true] iff [s] looks like an attempt at a number. *)

val to_string : float -> string
(** [to_string x] is the shortest of 15, 16 or 17 digits that reads as [x]. [x]
    must be finite. *)

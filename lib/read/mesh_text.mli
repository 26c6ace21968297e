(** Words in the lines of a mesh file.

    Local mutation: a text is read from its start to its end, once. Readers of
    mesh files stop at the first error by {!Refused}, which {!reading} makes a
    result. *)

type t

exception Refused of string

val reading : (t -> 'a) -> string -> ('a, string) result
(** [reading f s] is [f] of the text [s], or what it was {!Refused} for. *)

val refuse : t -> string -> 'a
(** [refuse t why] raises {!Refused}, with the number of the line. *)

val word : t -> string
(** [word t] is the next word of this line, empty at its end. A backslash at the
    end of a line joins the next one to it. *)

val need : t -> string -> string
(** [need t what] is {!word}; the end of the line is an error, where [what] is
    expected. *)

val length : t -> string -> float
(** [length t what] is a number from {!need}, of a size up to 2^400. *)

val next_line : t -> unit
(** [next_line t] leaves what is left of this line. *)

val is_over : t -> bool
(** [is_over t] is [true] iff nothing is left of the text. *)

val left : t -> int
(** [left t] is how many bytes are left. *)

val take : t -> int -> int
(** [take t n] is the offset in the text of the next [n] bytes, which are left
    behind. *)

val is_blank_line : t -> bool
(** [is_blank_line t] is [true] iff nothing but blanks is left of this line. *)

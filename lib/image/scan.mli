(** Words in the text that PPM and PFM files begin with, or consist of. Blanks
    separate words; a [#] starts a comment up to the end of its line. *)

type t
(** A place in a file, moved by every reading. Lives for one decoding. *)

val v : string -> t
(** [v file] is the place before the first byte of [file]. *)

val word : t -> string
(** [word s] is the next word, [""] at the end of the file. *)

val number : t -> string -> (int, string) result
(** [number s what] is the next word as a decimal number in \[0;999999999\]. The
    error says that [what] was expected, and what was found. *)

val left : t -> int
(** [left s] is the number of bytes from here to the end of the file. *)

val body : t -> bytes:int -> (int, string) result
(** [body s ~bytes] is the index of the binary data that begin after the one
    separator that follows the last word, or an error when fewer than [bytes]
    bytes are there. *)

val ends_early : needed:int -> left:int -> string
(** [ends_early ~needed ~left] is the message for a file cut short. *)

(** HTML, well formed by construction: every element is closed, and what is text
    stays text, whatever it holds. *)

type t
(** A piece of a page. *)

type attributes = (string * string) list
(** Names, which the caller spells right, and values, which may hold anything.
*)

val text : string -> t
(** [text s] is [s] to be read. Bytes that are not UTF-8, and control characters
    that HTML does not allow, become U+FFFD. *)

val element : string -> attributes -> t list -> t
(** [element name attributes children] is [<name …>children</name>]. *)

val void : string -> attributes -> t
(** [void name attributes] is [<name …>], for the elements that HTML never
    closes, such as [img]. *)

val to_string : t -> string
(** [to_string m] is [m] as HTML. *)

val document : t -> string
(** [document html] is [html] behind the declaration that it is HTML 5. *)

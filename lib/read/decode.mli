(** Readers of s-expressions, made of smaller ones.

    A form is a list that begins with a word, its head: [(radius 2)]. What
    follows the head is its body. Bodies of fields are in {!Fields}.

    A reader gives [None] if it has noted an error (see {!Notes}), and goes on
    to find further ones, but not those that only follow from the first. *)

(** {1 Values} *)

type 'a value
(** How to read one s-expression as an ['a]. *)

val read : 'a value -> Notes.t -> Located.t -> 'a option
(** [read v notes s] is what [v] reads in [s]. *)

val words : 'a value -> string list
(** [words v] is the heads of the forms that [v] reads. *)

val accepts : 'a value -> Located.t -> bool
(** [accepts v s] is [true] iff [s] is probably meant as a [v]. *)

val atom :
  expected:(unit -> string) ->
  (Notes.t -> Span.t -> string -> 'a option) ->
  'a value
(** [atom ~expected f] is a word or string read by [f]; of lists errors say what
    was [expected]. *)

val word : (string * 'a) list -> 'a value
(** [word cases] is one of these words. *)

val name : (string * Span.t) value
(** [name] is any word or string. *)

val reference : Notes.kind -> string value
(** [reference kind] is the name of something that is or will be defined. *)

(** {1 Bodies of forms} *)

type 'a body
(** How to read the body of a form as an ['a]. *)

val body : string -> (Notes.t -> Form.t -> 'a option) -> 'a body
(** [body arguments f] reads with [f]. Messages show the form as
    [(head arguments)]. *)

val read_body : 'a body -> Notes.t -> Form.t -> 'a option
(** [read_body b notes form] is what [b] reads in [form]. *)

val arguments : 'a body -> string
(** [arguments b] is what messages show. *)

val choice : string -> ?atom:'a value -> (string * 'a body) list -> 'a value
(** [choice what cases] is a form with one of these heads; errors call it
    [what]. A bare word or number is read by [atom]. *)

val tuple : 'a body -> 'a value
(** [tuple b] is a list that has only a body, as in [(0 1 0)]. *)

val one : string -> 'a value -> 'a body
(** [one arguments v] is just one [v]; for [arguments] see {!val-body}. *)

val several : string -> ((unit -> string) -> 'a value) -> 'a array body
(** [several "X Y Z" v] is as many values as there are names: [v called] each,
    where messages may call it [called ()]. *)

val triple : 'a body -> ('a * 'a * 'a) body
(** [triple b] is three lists with the body [b], as the normals of a triangle.
*)

val flag : unit body
(** [flag] is nothing: the head says it all. *)

val named : 'a body -> (string * Span.t * 'a option) body
(** [named b] is a name and then [b], or the name alone if [b] fails. *)

val referring : Notes.kind -> 'a body -> (string * 'a) body
(** [referring kind b] is a {!reference} and then [b]. *)

(** {1 Refinements} *)

val map_value : ('a -> 'b) -> 'a value -> 'b value
(** [map_value f v] is [f] of what [v] reads. *)

val placed : (Candor_scene.Place.t -> 'a) body -> 'a body
(** [placed b] is what [b] reads, told where the form is. *)

val map : ('a -> 'b) -> 'a body -> 'b body
(** [map f b] is [f] of what [b] reads. *)

val check : ('a -> ('b, string) result) -> 'a body -> 'b body
(** [check f b] is [f] of what [b] reads; the form is refused with the message
    of its [Error]. *)

val fix : ('a value -> 'a value) -> 'a value
(** [fix f] is the [v] that is [f v], for values that contain their like. *)

(** {1 For {!Fields}} *)

val all : 'a option list -> 'a list option
(** [all l] is what is in [l], unless there is a [None]. *)

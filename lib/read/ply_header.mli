(** What stands in a PLY file, as its head says. *)

type number =
  | Int8
  | Uint8
  | Int16
  | Uint16
  | Int32
  | Uint32
  | Float32
  | Float64

type property =
  | Scalar of string * number
  | List of string * number * number
      (** A list has its length first, as the first of the two. *)

type element = { name : string; count : int; properties : property array }
type form = Ascii | Binary of { big_endian : bool }
type t = { form : form; elements : element list }

val bytes : number -> int
(** [bytes n] is how many bytes a binary file has for it. *)

val is_whole : number -> bool

val read : Mesh_text.t -> t
(** [read text] is the head at the start of [text], up to the end of its last
    line. *)

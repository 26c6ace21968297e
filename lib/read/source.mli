(** The texts that a scene is made of. *)

type t

val of_string : name:string -> string -> t
(** [of_string ~name s] is the text [s], which errors call [name]. *)

val open_file : ?patience:float -> string -> (t, string) result
(** [open_file path] is the text of the file or pipe [path], open for {!input}.
    [Error why] if there is none, it is a directory, or it may not be read. A
    pipe that stays silent for [patience] seconds (default 5) is an error when
    it is read. *)

val close : t -> unit
(** [close s] ends the reading of [s]. {!slice} goes on to work. *)

val name : t -> string
(** [name s] is what the user or an [include] calls [s]. *)

val same : t -> t -> bool
(** [same a b] is [true] iff both are one file, under whatever names. *)

val beside : t -> string -> string
(** [beside s path] is [path] as seen from the folder of [s]. *)

val input : t -> bytes -> (int, string) result
(** [input s buffer] fills [buffer] from its start with the next bytes of [s];
    their number, 0 at the end. *)

val slice : t -> first:int -> last:int -> string
(** [slice s ~first ~last] is the bytes of [s] at the offsets in
    \[[first];[last]\[, as far as there are any, and at most {!most}. A regular
    file is read again; of other texts only what {!input} has read is known. *)

val most : int
(** [most] is the number of bytes that a buffer for {!input} should hold. *)

(** Files that are read in one go. *)

val of_file : what:string -> string -> (string, string) result
(** [of_file ~what path] is all bytes of the regular file [path], which should
    be [what], as in ["a picture"]. [Error why], on one line and without the
    name, if there is none, it may not be read, or it is not a regular file.
    Never raises. *)

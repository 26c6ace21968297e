(** Scenes as files. *)

open Candor_scene

val read : ?patience:float -> string -> (Scene.t, Error.report) result
(** [read path] is the scene in the file [path] and what that includes, or all
    that is wrong with it. Never raises. Takes time linear in the size of the
    text; of the text itself no more than one top-level form at a time is kept,
    unless [path] is a pipe. A pipe that stays silent for [patience] seconds
    (default 5) is an error. *)

val of_string : name:string -> string -> (Scene.t, Error.report) result
(** [of_string ~name text] is the scene [text]. Errors call it [name], and what
    it includes is looked for in the folder of [name]. *)

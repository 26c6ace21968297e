(** Meshes: triangles from the files that a scene names. *)

open Candor_scene

val load : string -> (Faces.t, string) result
(** [load path] is the mesh in the file [path], which {!Obj} or {!Ply} reads as
    its name ends in [.obj] or [.ply], in either case. Errors are one line,
    without the name of the file. Never raises. *)

val mesh : (Scene.shape -> 'a) Decode.body -> 'a Decode.body
(** [mesh attributes] is the name of a file, beside the one that names it, and
    then [attributes]. *)

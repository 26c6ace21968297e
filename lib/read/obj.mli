(** Meshes in Wavefront's OBJ.

    Of its statements these are read: [v x y z], [vt u v] (v is 0 if left out),
    [vn x y z], and [f] with corners [v], [v/vt], [v//vn] or [v/vt/vn]. Numbers
    of corners count from 1, or back from -1, what was the last above the face.
    All other statements, and what follows on these lines, are left aside; [#]
    begins a comment. *)

val read : string -> (Faces.t, string) result
(** [read text] is the mesh in the contents [text] of a file. [Error why] begins
    with the line where there is one. Never raises. *)

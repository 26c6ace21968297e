(** Meshes in PLY, the Stanford triangle format: text, and binary of either
    order of bytes.

    Of its elements [vertex] and [face] are read: [x], [y], [z], and if they are
    there [nx], [ny], [nz], and [u] and [v] or [s] and [t]; of a face the list
    [vertex_indices] or [vertex_index]. All others are passed over. *)

val read : string -> (Faces.t, string) result
(** [read text] is the mesh in the contents [text] of a file. [Error why] begins
    with the line, or in the binary part with the row, where there is one. Never
    raises. *)

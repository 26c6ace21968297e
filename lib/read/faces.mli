(** The faces of a mesh file, as the triangles that they mean. *)

open Candor_space
open Candor_surface

type t = { triangles : Triangle.t array; dropped : int }
(** The triangles in the order of the faces, and how many faces were left out
    since they have no area. *)

type corner

val corner : ?uv:float * float -> ?normal:Vec.t -> Point.t -> corner
(** [corner p] is a corner of a face at [p], within {!Reach}. A normal of zero
    counts as none. *)

type building
(** Faces read so far. Local mutation: it grows. *)

val start : unit -> building

val add : building -> corner array -> unit
(** [add b corners] is one more face, counter-clockwise as seen from outside,
    with three corners or more. What is without area, decided exactly, is left
    out. A triangle has normals iff its three corners have, and so for uv.

    A face with more corners is cut into triangles between them: a convex one
    fans out from its first corner; any other is cut as the {!Polygon} that is
    seen of it along the axis that it faces most, so that it need not be quite
    flat. Where sides cross, it is the fan. *)

val finish : building -> (t, string) result
(** [finish b] is all faces, or why there is nothing to see. *)

(** What surfaces may lack that some materials need. *)

open Candor_scene

type t =
  | Bounds  (** it is infinite: it may not emit *)
  | Inside  (** it is not closed: it may not be translucent *)
  | Uv  (** it has no texture coordinates: it may not show an image *)

val all : t list
(** [all] is each of them. *)

val is_of : grouped:bool -> Scene.shape -> t -> bool
(** [is_of ~grouped shape l] is [true] iff [shape] lacks [l]; groups and uses
    lack nothing themselves. Triangles and polygons that are [grouped] are
    trusted to close something together with their neighbours. A quadric has
    bounds if {!Candor_surface.Quadric.bounds} knows some. *)

val is_minded_by : Material.t -> t -> bool
(** [is_minded_by m l] is [true] iff a surface of [m] must not lack [l]. *)

val complaint : t -> string
(** [complaint l] says so. *)

val advice : t -> Scene.shape -> string
(** [advice l shape] is what to do about it. *)

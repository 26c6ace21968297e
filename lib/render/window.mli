(** A part of a picture. *)

open Candor_scene

type t = { x0 : int; y0 : int; x1 : int; y1 : int } [@@deriving show, eq]
(** The pixels x0 ≤ x < x1, y0 ≤ y < y1 of the full picture. *)

val full : Scene.t -> t
(** [full s] is all of [s]'s picture. *)

val width : t -> int
val height : t -> int

val join : t -> t -> t
(** [join v w] is the least window that has the pixels of both. *)

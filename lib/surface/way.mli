(** The way from the outermost space into the space of a surface: the groups
    that a query has entered and the motions that it has followed, innermost
    first. *)

open Candor_space

type t =
  | Outermost
  | Within of { index : int; transform : Transform.t option; around : t }
      (** within the group that stands at place [index] in what is [around] *)
  | Moved of { by : Vec.t; around : t }
      (** along with a surface that has moved in what is [around]; it keeps its
          place there *)

val path : t -> int -> int list
(** [path way i] is where place [i] at the end of [way] is, from the top level
    down. *)

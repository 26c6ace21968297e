(** What is wrong with a scene, for whoever wrote it. *)

open Candor_scene

type t = {
  place : Place.t;  (** line 0 where a file could not be read at all *)
  message : string;
  hint : string option;  (** what was expected or probably meant *)
  excerpt : Excerpt.t option;
}

val pp : Format.formatter -> t -> unit
(** [pp] prints an error as compilers do, with the line and a caret below:
    {v
    desk.scene:17:11: unknown field `radious` in (sphere ...); did you mean `radius`?
       17 |   (sphere (radious 2) (center 0 1 0))
          |            ^^^^^^^
    v} *)

type report = {
  errors : t list;  (** by place, at most {!most} of them *)
  more : int;  (** how many there were besides *)
}
(** All that is wrong with a scene. *)

val most : int
(** [most] is 50. *)

val pp_report : Format.formatter -> report -> unit
(** [pp_report] prints each error, how many more there are, and the number of
    all on a last line. *)

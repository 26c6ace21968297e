(** Why an effect is on: what in the scene asks for it, and where. *)

open Candor_scene

type t = { what : string; place : Place.t } [@@deriving show, eq, ord]

val v : string -> Place.t -> t

val of_use : Assembly.use -> t
(** [of_use u] names the material and the place that says so. *)

val materials : (Material.t -> bool) -> Scene.t -> t list
(** [materials p s] are the materials in use in [s] that satisfy [p]. *)

val receivers : Scene.t -> t list
(** [receivers s] is where light that falls can be seen: surfaces that spread
    it, and media that scatter it. *)

(** A scene, as its files describe it. *)

open Candor_space
open Candor_colour
open Candor_surface

type background =
  | Uniform of Rgb.t
  | Gradient of { down : Rgb.t; up : Rgb.t }
      (** linear in the direction's y, from straight down to straight up *)
[@@deriving show, eq, ord]

type filter =
  | Box  (** samples spread evenly over the pixel *)
  | Tent  (** samples over ±1 pixel with density (1−|x|)(1−|y|) *)
[@@deriving show, eq, ord]

type settings = {
  spp : int;  (** samples per pixel, at least 1 *)
  depth : int;  (** most reflections along one path; 0: the first hit only *)
  cutoff : float;
      (** paths whose largest throughput component is below this end *)
  seed : int;
  filter : filter;
}
[@@deriving show, eq, ord]

type material =
  | Named of string  (** one of the scene's [materials] *)
  | Inline of Material.t
[@@deriving show, eq, ord]

type surface = { shape : shape; material : material option; place : Place.t }
(** A surface of [material], or else of the nearest enclosing group's. *)

and shape =
  | Sphere of Sphere.t
  | Box of Box.t
  | Triangle of Triangle.t
  | Quadric of Quadric.t
  | Polygon of Polygon.t
  | Group of { transform : Transform.step list; surfaces : surface list }
  | Use of { transform : Transform.step list; name : string }
      (** one of the scene's [definitions] *)
[@@deriving show, eq]

type 'a named = { name : string; value : 'a; place : Place.t }
[@@deriving show, eq]

type 'a placed = { value : 'a; place : Place.t } [@@deriving show, eq]

type t = {
  width : int;
  height : int;  (** pixels, at least 1 each way *)
  camera : Camera.t;
  background : background;
  ambient : Rgb.t placed option;  (** L_a *)
  settings : settings;
  lights : Light.t list;
  materials : Material.t named list;
  definitions : surface list named list;
  surfaces : surface list;
}
[@@deriving show, eq]
(** All names refer to something, definitions form no cycle, and every transform
    can be undone: whoever makes a scene sees to that. *)

val default_settings : settings
(** [default_settings] is 16 samples per pixel, depth 8, cutoff 0, seed 0, box
    filter. *)

val forget_places : t -> t
(** [forget_places s] is [s] with {!Place.unknown} everywhere: two scenes are
    the same iff theirs are equal. *)

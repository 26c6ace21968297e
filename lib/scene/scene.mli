(** A scene, as its files describe it. *)

open Candor_space
open Candor_colour
open Candor_surface

type background =
  | Uniform of Rgb.t
  | Gradient of { down : Rgb.t; up : Rgb.t }
      (** linear in the direction's y, from straight down to straight up *)
  | Image of { file : string; texels : Texels.t }
      (** equirectangular radiance; [file] is the name as written *)
[@@deriving show, eq, ord]

type filter =
  | Box  (** samples spread evenly over the pixel *)
  | Tent  (** samples over ±1 pixel with density (1−|x|)(1−|y|) *)
[@@deriving show, eq, ord]

type settings = {
  spp : int;  (** samples per pixel, at least 1 *)
  depth : int option;
      (** most reflections, refractions and bounces along one path; 0: the first
          hit only; see {!depth} *)
  cutoff : float;
      (** paths whose largest throughput component is below this end *)
  seed : int;
  filter : filter;
  error : float option;
      (** the greatest RMS error of the displayed picture, in units of 1/255: as
          many samples as that takes, [spp] at most *)
  time : float option;  (** seconds to spend on it, likewise *)
}
[@@deriving show, eq, ord]

type material =
  | Named of string  (** one of the scene's [materials] *)
  | Inline of Material.t
[@@deriving show, eq, ord]

type surface = {
  shape : shape;
  material : material option;  (** else the nearest enclosing group's *)
  motion : Vec.t;
      (** at time t the surface stands moved by t·motion, in its parent's axes
      *)
  both_sides : bool;
      (** whether it, or what is in it, also emits from inner sides *)
  place : Place.t;
}

and shape =
  | Sphere of Sphere.t
  | Box of Box.t
  | Triangle of Triangle.t
  | Quadric of Quadric.t
  | Polygon of Polygon.t
  | Mesh of {
      file : string;  (** the name as written *)
      triangles : (Triangle.t array[@opaque]);
          (** its members in order; not shown *)
      dropped : int;  (** faces of the file left out, for they have no area *)
    }
  | Group of { transform : Transform.step list; surfaces : surface list }
  | Use of { transform : Transform.step list; name : string }
      (** one of the scene's [definitions] *)
[@@deriving show, eq]

type 'a named = { name : string; value : 'a; place : Place.t }
[@@deriving show, eq]

type 'a placed = { value : 'a; place : Place.t } [@@deriving show, eq]

type fog = {
  extinction : Rgb.t;  (** per unit length *)
  albedo : Rgb.t;  (** the part of it that is scattered *)
  anisotropy : float;  (** Henyey and Greenstein's, in \]-1;1\[ *)
  within : Bounds.t option;  (** where it is; else everywhere *)
}
[@@deriving show, eq]
(** A homogeneous medium in what would be empty space. *)

type t = {
  width : int;
  height : int;  (** pixels, at least 1 each way *)
  camera : Camera.t;
  background : background;
  ambient : Rgb.t placed option;  (** L_a *)
  indirect : Place.t option;
      (** where light that bounces is asked for, if it is *)
  fog : fog placed option;
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
(** [default_settings] is 16 samples per pixel, no depth of its own, cutoff 0,
    seed 0, box filter, no error or time of its own. *)

val most_samples : int
(** [most_samples] is the greatest number of samples per pixel, 2^30: that of
    settings with an error or a time and no number. *)

val plain : shape -> Place.t -> surface
(** [plain shape place] is at rest, has no material of its own and emits from
    its outer side only. *)

val depth : t -> int
(** [depth s] is the greatest depth of paths: as the settings say, else 8, or
    without limit ([max_int]) under indirect light. *)

val is_still : surface -> bool
(** [is_still s] is [true] iff [s] itself does not move. *)

val forget_places : t -> t
(** [forget_places s] is [s] with {!Place.unknown} everywhere: two scenes are
    the same iff theirs are equal. *)

(** Where a picture is taken from. *)

open Candor_space

type window = { left : float; right : float; bottom : float; top : float }
[@@deriving show, eq, ord]
(** The part of the image plane that the picture shows, in scene units to the
    right of and above the line of sight. *)

type frame =
  | Perspective_angle of { fov_y : float }
      (** the vertical angle of view in degrees, between 0 and 180 *)
  | Perspective_window of { window : window; distance : float }
      (** the image plane is at [distance] in front of the eye *)
  | Orthographic_height of { height : float }
      (** rays are parallel; the picture shows this height of the scene *)
  | Orthographic_window of { window : window }
[@@deriving show, eq, ord]

type t = {
  eye : Point.t;
  look_at : Point.t;
  up : Vec.t;
  frame : frame;
  near : float option;
      (** rays start on the plane at this distance instead of at the eye *)
}
[@@deriving show, eq, ord]

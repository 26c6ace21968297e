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
  | Panorama  (** 360° across and 180° down; look-at is in the middle *)
[@@deriving show, eq, ord]

type lens = {
  radius : float;  (** of the aperture, in scene units *)
  focus : float;  (** distance of the plane that is sharp, along the view *)
}
[@@deriving show, eq, ord]
(** A thin lens. *)

type shutter = { opens : float; closes : float } [@@deriving show, eq, ord]
(** When light is let in; [opens] ≤ [closes]. *)

type t = {
  eye : Point.t;
  look_at : Point.t;
  up : Vec.t;
  frame : frame;
  near : float option;
      (** rays start on the plane at this distance instead of at the eye *)
  lens : lens option;  (** else a pinhole *)
  shutter : shutter;
  place : Place.t;
}
[@@deriving show, eq, ord]

val instant : shutter
(** [instant] opens and closes at time 0. *)

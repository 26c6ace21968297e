open Candor_space

type window = { left : float; right : float; bottom : float; top : float }
[@@deriving show, eq, ord]

type frame =
  | Perspective_angle of { fov_y : float }
  | Perspective_window of { window : window; distance : float }
  | Orthographic_height of { height : float }
  | Orthographic_window of { window : window }
  | Panorama
[@@deriving show, eq, ord]

type lens = { radius : float; focus : float } [@@deriving show, eq, ord]
type shutter = { opens : float; closes : float } [@@deriving show, eq, ord]

type t = {
  eye : Point.t;
  look_at : Point.t;
  up : Vec.t;
  frame : frame;
  near : float option;
  lens : lens option;
  shutter : shutter;
  place : Place.t;
}
[@@deriving show, eq, ord]

let instant = { opens = 0.; closes = 0. }

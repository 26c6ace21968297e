open Candor_space

type window = { left : float; right : float; bottom : float; top : float }
[@@deriving show, eq, ord]

type frame =
  | Perspective_angle of { fov_y : float }
  | Perspective_window of { window : window; distance : float }
  | Orthographic_height of { height : float }
  | Orthographic_window of { window : window }
[@@deriving show, eq, ord]

type t = {
  eye : Point.t;
  look_at : Point.t;
  up : Vec.t;
  frame : frame;
  near : float option;
}
[@@deriving show, eq, ord]

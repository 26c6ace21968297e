open Candor_space

type t =
  | Matrix of float array
  | Form of { a : float array; b : Vec.t; c : float }
  | Plane of { normal : Vec.t; offset : float }
  | Ellipsoid of { center : Point.t; radii : Vec.t }
  | Cylinder of { from : Point.t; until : Point.t; radius : float }
  | Cone of { apex : Point.t; base : Point.t; radius : float }
  | Paraboloid of { apex : Point.t; base : Point.t; radius : float }
  | Hyperbolic_paraboloid of { center : Point.t; radii : Vec.t }
  | Hyperboloid_one_sheet of { center : Point.t; radii : Vec.t }
  | Hyperboloid_two_sheets of { center : Point.t; radii : Vec.t }
[@@deriving show, eq, ord]

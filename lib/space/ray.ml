type departure =
  | Nowhere
  | Surface of { path : int list; part : int; side : Side.t }
[@@deriving show, eq, ord]

type t = {
  origin : Point.t;
  direction : Vec.t;
  direction_low : Vec.t;
  departure : departure;
}
[@@deriving show, eq, ord]

let leaving departure origin direction =
  { origin; direction; direction_low = Vec.zero; departure }

let v origin direction = leaving Nowhere origin direction

let toward p r =
  let direction = Point.sub p r.origin in
  let direction_low = Unrounded.diff_error p r.origin direction in
  { r with direction; direction_low }

let at r t = Point.along r.origin r.direction t

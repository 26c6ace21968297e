type departure =
  | Nowhere
  | Surface of { path : int list; part : int; side : Side.t }
[@@deriving show, eq, ord]

type t = { origin : Point.t; direction : Vec.t; departure : departure }
[@@deriving show, eq, ord]

let v origin direction = { origin; direction; departure = Nowhere }
let at r t = Point.along r.origin r.direction t

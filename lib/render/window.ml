open Candor_scene

type t = { x0 : int; y0 : int; x1 : int; y1 : int } [@@deriving show, eq]

let full (s : Scene.t) = { x0 = 0; y0 = 0; x1 = s.width; y1 = s.height }
let width w = w.x1 - w.x0

let join v w =
  {
    x0 = Int.min v.x0 w.x0;
    y0 = Int.min v.y0 w.y0;
    x1 = Int.max v.x1 w.x1;
    y1 = Int.max v.y1 w.y1;
  }

let height w = w.y1 - w.y0

open Candor_scene

type t = { x0 : int; y0 : int; x1 : int; y1 : int } [@@deriving show, eq]

let full (s : Scene.t) = { x0 = 0; y0 = 0; x1 = s.width; y1 = s.height }
let width w = w.x1 - w.x0
let height w = w.y1 - w.y0

type t = { r : float; g : float; b : float } [@@deriving show, eq, ord]

let v r g b = { r; g; b }
let grey k = { r = k; g = k; b = k }
let black = grey 0.
let white = grey 1.
let add a b = { r = a.r +. b.r; g = a.g +. b.g; b = a.b +. b.b }
let mul a b = { r = a.r *. b.r; g = a.g *. b.g; b = a.b *. b.b }
let scale k c = { r = k *. c.r; g = k *. c.g; b = k *. c.b }
let is_black c = c.r = 0. && c.g = 0. && c.b = 0.

let is_finite c =
  Float.is_finite c.r && Float.is_finite c.g && Float.is_finite c.b

let greater a b =
  { r = Float.max a.r b.r; g = Float.max a.g b.g; b = Float.max a.b b.b }

let largest c =
  let m = if c.r > c.g then c.r else c.g in
  if m > c.b then m else c.b

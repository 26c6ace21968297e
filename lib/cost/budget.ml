open Candor_render

type t = { clock : Clock.t; whole : float }

let start whole = { clock = Clock.start (); whole }
let whole b = b.whole
let spent b = Clock.seconds b.clock
let kept_back = 0.05
let left b = Float.max 0. ((b.whole *. (1. -. kept_back)) -. spent b)

type t = { clock : Mtime_clock.counter; whole : float }

let start whole = { clock = Mtime_clock.counter (); whole }
let whole b = b.whole
let spent b = Mtime.Span.to_float_ns (Mtime_clock.count b.clock) /. 1e9
let kept_back = 0.05
let left b = Float.max 0. ((b.whole *. (1. -. kept_back)) -. spent b)

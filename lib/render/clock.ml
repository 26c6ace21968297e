type t = Mtime_clock.counter

let in_seconds span = Mtime.Span.to_float_ns span /. 1e9
let start = Mtime_clock.counter
let seconds c = in_seconds (Mtime_clock.count c)
let of_program () = in_seconds (Mtime_clock.elapsed ())

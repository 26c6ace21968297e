open Candor_colour

type t = { throughput : Rgb.t; depth : int }

let start = { throughput = Rgb.white; depth = 0 }

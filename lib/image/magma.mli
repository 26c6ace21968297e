(** The colour map {e magma} (S. van der Walt, N. Smith, 2015, made free of
    rights by CC0): black for 0, by way of purple, red and orange, to a pale
    yellow for 1, ever lighter, in 256 steps. *)

open Candor_colour

val colour : float -> Rgb.t
(** [colour v] is the light that {!Candor_colour.Display.level} turns into the
    map's colour for [v]: that of the nearest step, half up. Below 0 and for
    [nan] it is that for 0, above 1 that for 1. *)

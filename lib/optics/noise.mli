(** Gradient noise: smooth random patterns in space.

    Every point of the integer lattice has a gradient, chosen by a
    {!Candor_sample.Key} of its coordinates; between the points the linear
    functions with these gradients are blended by 6t⁵ − 15t⁴ + 10t³. After K.
    Perlin, {e Improving Noise}, SIGGRAPH 2002, but for his table of hashes. The
    pattern repeats after 2^32 units along each axis. *)

open Candor_space

val gradient : layer:int -> Point.t -> float
(** [gradient ~layer p] is the noise at [p], in \[-1;1\], 0 at points of the
    lattice, with continuous second derivatives. Layers are patterns of their
    own. Perlin's function times 15/16, because that reaches 1.0364. Total: a
    coordinate that is not finite counts as one of the lattice. *)

val fractal : octaves:int -> Point.t -> float
(** [fractal ~octaves p] is the mean of [gradient ~layer:i (2^i·p)], i from 0 to
    [octaves - 1], with weights in proportion to 2^-i; in \[-1;1\]. Fewer than
    one octave count as one; those after the 53rd, whose weights are below
    rounding, as none. *)

val mix : octaves:int -> Point.t -> float
(** [mix ~octaves p] is ½ + ½·[fractal ~octaves p], in \[0;1\]: the weight of
    the second of two colours that are mixed. *)

(** Places in a pixel that share it out among a known number of samples. *)

type t
(** The samples of every pixel of one picture. *)

type position = { u : float; v : float }
(** A place in the unit square, \[0;1\[ both ways. *)

val make : seed:int -> spp:int -> t
(** [make ~seed ~spp] is a pattern of [spp ≥ 1] samples per pixel. *)

val position : t -> x:int -> y:int -> int -> position
(** [position p ~x ~y s] is where sample [s] (0 ≤ s < spp) of pixel (x, y) is.
    They are stratified: each of the spp rows of the pixel holds one, and so
    does each cell of a grid of about √spp by √spp; every sample by itself is
    uniform. After A. Kensler, {e Correlated Multi-Jittered Sampling}, Pixar
    technical memo 13-01, 2013. *)

val tent : float -> float
(** [tent u] takes uniform [u] in \[0;1\[ to \[-1;1\[ with density 1 − |x|; .5
    to 0. *)

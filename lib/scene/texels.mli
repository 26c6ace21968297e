(** Pictures as scenes use them: linear RGB in rows and columns, looked up
    between texel centres.

    The square of texture coordinates has u to the right and v up: the centre of
    the texel in column x and row y, both counted from 0 at the top left, is at
    u = (x + .5)/width, v = 1 − (y + .5)/height. Values are meant to be finite
    and not negative; whoever makes texels sees to that. *)

open Candor_space
open Candor_colour

type t [@@deriving show, eq, ord]
(** At least one texel each way. Equal iff of one size and with equal texels. It
    is shown as its size and a hash of its contents; showing takes time linear
    in the size. *)

val init : width:int -> height:int -> (int -> int -> Rgb.t) -> t
(** [init ~width ~height f] has the texel [f x y] in column [x], row [y]. Raises
    [Invalid_argument] unless both sides are at least 1. *)

val width : t -> int
val height : t -> int

val get : t -> int -> int -> Rgb.t
(** [get t x y] is the texel in column [x], row [y] from the top. Raises
    [Invalid_argument] outside. *)

val exists : (Rgb.t -> bool) -> t -> bool
(** [exists p t] is [true] iff [p] holds for some texel. *)

val greatest : t -> Rgb.t
(** [greatest t] has the greatest red, green and blue of all texels. *)

(** {1 Lookups}

    Both are bilinear: at a texel's centre they are the texel, and between four
    centres linear in u and in v. They are never negative, and never above the
    greatest of the four. *)

val bilinear_repeating : t -> u:float -> v:float -> Rgb.t
(** [bilinear_repeating t ~u ~v] is the colour at (u, v), where [t] repeats with
    period 1 both ways. Total: what is not finite counts as 0. *)

type place = { u : float; v : float }
(** Texture coordinates, in \[0;1\]. *)

val towards : Vec.t -> place
(** [towards d] is where an equirectangular picture shows the finite direction
    [d] of any length: u = ½ + atan2(d.x, −d.z)/2π, and v from 0 straight down
    to 1 straight up, linear in the angle. The centre is towards −z, with +x on
    its right. *)

val radiance_at : t -> place -> Rgb.t
(** [radiance_at t (towards d)] is [radiance t d]. *)

val radiance : t -> Vec.t -> Rgb.t
(** [radiance t d] is what the equirectangular [t] shows towards [d]: around the
    turn it repeats; beyond the centres of the first and the last row it is
    constant in v. *)

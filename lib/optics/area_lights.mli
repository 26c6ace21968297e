(** The area lights of a scene, and directions towards them.

    At a point one light is chosen and a direction towards it; whether it is met
    there, and what with, is for a ray to find out. Lights count by the largest
    component of their radiance times the solid angle that they fill at the
    point: that exactly where there are few, by groups of them in a
    {!Light_tree} where there are many. What walls hide ({!Enclosure}) is left
    out. *)

open Candor_space
open Candor_colour
open Candor_sample
open Candor_scene

type t

val make : Scene.t -> t
(** [make s] are the emitters of [s], in the order of their paths. *)

val is_empty : t -> bool
(** [is_empty t] is [true] iff nothing emits. *)

val emitters : t -> Emitters.t list
(** [emitters t] are the lights; the first has index 0. *)

val radiance : t -> int -> Rgb.t
(** [radiance t i] is that of light [i]; black if there is no such light. *)

val index : t -> int list -> int option
(** [index t path] is the index of the light at the place [path] that a hit
    reports, if one is there. *)

val is_at : t -> int -> int list -> bool
(** [is_at t i path] is [index t path = Some i]. *)

val chooses : t -> bool
(** [chooses t] is whether there is more than one light, so that {!sample} asks
    for [choice]. *)

type vantage = {
  from : Point.t;
  departure : Ray.departure;
      (** the surface that the point is on, with the side of it that light is to
          reach, as of a ray that leaves on that side; [Nowhere] in empty space
      *)
  time : float;
}
(** A place to receive light at. *)

type sample = {
  index : int;  (** of the light that was chosen *)
  direction : Dir.t;  (** in which it may be met *)
  density : float;
      (** per steradian, above 0: that of [direction] when light [index] is met
          there *)
}

val sample : t -> vantage -> choice:float -> Pattern.position -> sample option
(** [sample t v ~choice p] is a light chosen by uniform [choice] in \[0;1\[ and
    a direction towards it by uniform [p]. [None] where no light is seen, or for
    some of [choice] and [p] where a part of one is. *)

val density : t -> vantage -> index:int -> Dir.t -> float
(** [density t v ~index d] is the density with which [sample t v] takes light
    [index] and the direction [d]: what a ray along [d] that first meets that
    light is to be weighed by. 0 where it never does. *)

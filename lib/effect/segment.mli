(** What happens to light on its way from one surface to the next. *)

open Candor_space
open Candor_colour
open Candor_optics

type arrive = Path.t -> Ray.t -> Tracer.hit option -> Rgb.t
(** What is found at the end of a ray: on the surface that it meets, or in the
    sky. *)

type t =
  Term.radiance ->
  Tally.t ->
  Path.t ->
  Ray.t ->
  Tracer.hit option ->
  arrive ->
  Rgb.t
(** The radiance that a ray brings that meets the hit. *)

val length : Ray.t -> Tracer.hit option -> float
(** [length r hit] is the length of the ray up to the hit, in scene units;
    infinite without one. *)

val weighted : Rgb.t -> Path.t -> Ray.t -> Tracer.hit option -> arrive -> Rgb.t
(** [weighted w p r hit arrive] is what is found at the end, times [w]. *)

val distance : Point.t -> Illumination.source -> float
(** [distance p l] is how far [l] is from [p]; infinite where it only has a
    direction. *)

val after : t -> t -> t
(** [after a b] is [a], and then [b] where [a] arrives. *)

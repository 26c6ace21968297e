(** How near lights are to what they shine on. *)

open Candor_space
open Candor_scene

val to_bounds : Bounds.t -> Point.t -> float
(** [to_bounds b p] is a lower bound, in scene units, on the distance from [p]
    to what [b] holds; 0 where [b] is not finite, unless it is empty. *)

val to_surfaces : Scene.t -> Point.t -> float
(** [to_surfaces s] is the function from a point to a lower bound on its
    distance from every surface of [s], while the shutter is open; 0 where none
    is known, infinite where there is no surface. Spheres, boxes and planes that
    nothing moves count as they are, everything else by boxes around it. *)

(** The spheres, boxes, triangles and quadrics that a scene comes down to, each
    where it stands in the world. *)

open Candor_space
open Candor_surface

type shape =
  | Sphere of Sphere.t
  | Box of Box.t
  | Triangle of Triangle.t  (** also those that a polygon means *)
  | Quadric of Quadric.t

type t = {
  shape : shape;  (** in its own space *)
  transform : Transform.t option;
      (** from there to the world, all groups around composed *)
  velocity : Vec.t;
      (** in the world: at time t it stands moved by t·velocity, which is the
          sum of its own motion and those of the groups around it, each turned
          by the transforms outside *)
  material : Material.t;  (** resolved *)
  both_sides : bool;  (** whether it emits from both, if at all *)
  path : int list;  (** as hits report it *)
  place : Place.t;  (** where it is written *)
}

val of_scene :
  ?uses:bool -> keep:(shape -> Material.t -> bool) -> Scene.t -> t list
(** [of_scene ~keep s] are the primitives of [s] that [keep] is true of, in the
    order of their paths. With [~uses:false] (default [true]) those that only
    uses of definitions bring in are left out: then there are no more than stand
    in the files. The time taken is linear in the size of the scene and of what
    is kept. *)

(** What a surface says about one of its points, in its own space. *)

open Candor_space

type t = {
  point : Point.t;  (** as close to the surface as doubles allow *)
  normal : Dir.t;  (** the unit geometric normal, towards the outside *)
  error : Vec.t;
      (** non-negative; how far each coordinate of [point] may be from a point
          of the true surface *)
  flat : bool;  (** whether the surface is flat around the point *)
  uv : (float * float) option Lazy.t;
      (** where the surface has such coordinates *)
  shading_normal : Dir.t option;
      (** interpolated, where a triangle asks for it *)
}

(** What a surface says about one of its points, in its own space. *)

open Candor_space

type smooth = {
  outward : Dir.t;  (** its unit normal, interpolated *)
  above : Vec.t;
      (** from the point to where the curved surface bulges beyond it, on the
          side that [outward] points to; zero where it does not *)
  below : Vec.t;  (** the same on the other side *)
}
(** The curved surface that a flat one stands for, at one point. *)

type t = {
  point : Point.t;  (** as close to the surface as doubles allow *)
  normal : Dir.t;  (** the unit geometric normal, towards the outside *)
  error : Vec.t;
      (** non-negative; how far each coordinate of [point] may be from a point
          of the true surface *)
  flat : bool;  (** whether the surface is flat around the point *)
  uv : (float * float) option Lazy.t;
      (** where the surface has such coordinates *)
  smooth : smooth option;  (** where a triangle has normals of its own *)
}

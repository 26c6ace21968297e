open Candor_space

type smooth = { outward : Dir.t; above : Vec.t; below : Vec.t }

type t = {
  point : Point.t;
  normal : Dir.t;
  error : Vec.t;
  flat : bool;
  uv : (float * float) option Lazy.t;
  smooth : smooth option;
}

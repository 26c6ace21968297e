open Candor_space

type t = {
  point : Point.t;
  normal : Dir.t;
  error : Vec.t;
  flat : bool;
  uv : (float * float) option Lazy.t;
  shading_normal : Dir.t option;
}

open Candor_number
open Candor_space

type t = {
  cx : float;
  cy : float;
  cz : float;
  axx : float;
  ayy : float;
  azz : float;
  axy : float;
  axz : float;
  ayz : float;
  gx : float;
  gy : float;
  gz : float;
  k : float;
  a_size : float;
  g_size : float;
}
[@@deriving show, eq, ord]

let nothing =
  {
    cx = 0.;
    cy = 0.;
    cz = 0.;
    axx = 0.;
    ayy = 0.;
    azz = 0.;
    axy = 0.;
    axz = 0.;
    ayz = 0.;
    gx = 0.;
    gy = 0.;
    gz = 0.;
    k = 0.;
    a_size = 0.;
    g_size = 0.;
  }

let is_linear f =
  f.axx = 0. && f.ayy = 0. && f.azz = 0. && f.axy = 0. && f.axz = 0.
  && f.ayz = 0.

let is_constant f = is_linear f && f.gx = 0. && f.gy = 0. && f.gz = 0.
let center f = Point.v f.cx f.cy f.cz

let sized f =
  let diagonal = Vec.v f.axx f.ayy f.azz and beside = Vec.v f.axy f.axz f.ayz in
  let norm =
    Vec.norm (Vec.v (Vec.norm diagonal) (sqrt 2. *. Vec.norm beside) 0.)
  in
  let up x = x *. (1. +. 0x1p-49) in
  { f with a_size = up norm; g_size = up (Vec.norm (Vec.v f.gx f.gy f.gz)) }

let about (p : Point.t) f = { f with cx = p.x; cy = p.y; cz = p.z }

(* identity - s v vT *)
let across (v : Vec.t) s =
  {
    nothing with
    axx = 1. -. (s *. v.x *. v.x);
    ayy = 1. -. (s *. v.y *. v.y);
    azz = 1. -. (s *. v.z *. v.z);
    axy = -.(s *. v.x *. v.y);
    axz = -.(s *. v.x *. v.z);
    ayz = -.(s *. v.y *. v.z);
  }

let diagonal x y z = { nothing with axx = x; ayy = y; azz = z }
let squares (r : Vec.t) = (r.x *. r.x, r.y *. r.y, r.z *. r.z)

let raw : Quadric_shape.t -> t = function
  | Matrix q ->
      {
        nothing with
        axx = q.(0);
        ayy = q.(5);
        azz = q.(10);
        axy = q.(1);
        axz = q.(2);
        ayz = q.(6);
        gx = q.(3);
        gy = q.(7);
        gz = q.(11);
        k = q.(15);
      }
  | Form { a; b; c } ->
      {
        nothing with
        axx = a.(0);
        ayy = a.(4);
        azz = a.(8);
        axy = a.(1);
        axz = a.(2);
        ayz = a.(5);
        gx = -.b.x;
        gy = -.b.y;
        gz = -.b.z;
        k = c;
      }
  | Plane { normal = n; offset } ->
      {
        nothing with
        gx = n.x /. 2.;
        gy = n.y /. 2.;
        gz = n.z /. 2.;
        k = -.offset;
      }
  | Ellipsoid { center; radii } ->
      let x, y, z = squares radii in
      about center { (diagonal (1. /. x) (1. /. y) (1. /. z)) with k = -1. }
  | Cylinder { from; until; radius } ->
      let v = Point.sub until from in
      about from
        { (across v (1. /. Vec.dot v v)) with k = -.(radius *. radius) }
  | Cone { apex; base; radius } ->
      let v = Point.sub base apex in
      let l2 = Vec.dot v v in
      about apex (across v ((1. +. (radius *. radius /. l2)) /. l2))
  | Paraboloid { apex; base; radius } ->
      let v = Point.sub base apex in
      let l2 = Vec.dot v v in
      let s = -.(radius *. radius) /. (2. *. l2) in
      about apex
        {
          (across v (1. /. l2)) with
          gx = s *. v.x;
          gy = s *. v.y;
          gz = s *. v.z;
        }
  | Hyperbolic_paraboloid { center; radii } ->
      let x, y, _ = squares radii in
      about center
        { (diagonal (1. /. x) (-1. /. y) 0.) with gz = -0.5 /. radii.z }
  | Hyperboloid_one_sheet { center; radii } ->
      let x, y, z = squares radii in
      about center { (diagonal (1. /. x) (1. /. y) (-1. /. z)) with k = -1. }
  | Hyperboloid_two_sheets { center; radii } ->
      let x, y, z = squares radii in
      about center { (diagonal (1. /. x) (1. /. y) (-1. /. z)) with k = 1. }

let of_shape s = sized (raw s)
let slope f = Vec.v f.gx f.gy f.gz

let[@inline] times f (y : Vec.t) =
  Vec.v
    ((f.axx *. y.x) +. (f.axy *. y.y) +. (f.axz *. y.z))
    ((f.axy *. y.x) +. (f.ayy *. y.y) +. (f.ayz *. y.z))
    ((f.axz *. y.x) +. (f.ayz *. y.y) +. (f.azz *. y.z))

let gradient f y = Vec.add (times f y) (slope f)

let gradient_size f (y : Vec.t) =
  let abs = Float.abs in
  let row a b c g =
    (abs a *. abs y.x) +. (abs b *. abs y.y) +. (abs c *. abs y.z) +. abs g
  in
  Vec.v
    (row f.axx f.axy f.axz f.gx)
    (row f.axy f.ayy f.ayz f.gy)
    (row f.axz f.ayz f.azz f.gz)

(* {1 In twice the precision}

   Every number is a sum of two doubles, the second in a variable of the same
   name with a prime; written out, since this is done for each hit. *)

type applied = {
  u : float;
  v : float;
  w : float;
  u' : float;
  v' : float;
  w' : float;
}

(* A (p + p') *)
let applied f (p : Vec.t) (p' : Vec.t) =
  let open Error_free in
  let x = p.x and y = p.y and z = p.z in
  let x' = p'.x and y' = p'.y and z' = p'.z in
  let u = dot f.axx f.axy f.axz x y z
  and v = dot f.axy f.ayy f.ayz x y z
  and w = dot f.axz f.ayz f.azz x y z in
  {
    u;
    v;
    w;
    u' = dot_error f.axx f.axy f.axz x y z u +. dot f.axx f.axy f.axz x' y' z';
    v' = dot_error f.axy f.ayy f.ayz x y z v +. dot f.axy f.ayy f.ayz x' y' z';
    w' = dot_error f.axz f.ayz f.azz x y z w +. dot f.axz f.ayz f.azz x' y' z';
  }

(* What dot u v w d.x d.y d.z = q leaves of the product with d + d'. *)
let[@inline] rest { u; v; w; u'; v'; w' } (d : Vec.t) (d' : Vec.t) q =
  let open Error_free in
  dot_error u v w d.x d.y d.z q
  +. dot u' v' w' d.x d.y d.z +. dot u v w d'.x d'.y d'.z

let bend f (d : Vec.t) d' =
  let open Error_free in
  let ad = applied f d d' in
  let a = dot ad.u ad.v ad.w d.x d.y d.z in
  two_sum a (rest ad d d' a)

let rise f p p' (d : Vec.t) (d' : Vec.t) =
  let open Error_free in
  let ap = applied f p p' in
  let q = dot ap.u ap.v ap.w d.x d.y d.z in
  let g = dot f.gx f.gy f.gz d.x d.y d.z in
  let g' =
    dot_error f.gx f.gy f.gz d.x d.y d.z g +. dot f.gx f.gy f.gz d'.x d'.y d'.z
  in
  let b = q +. g in
  two_sum b (sum_error q g b +. (rest ap d d' q +. g'))

let value f (p : Vec.t) (p' : Vec.t) =
  let open Error_free in
  let ap = applied f p p' in
  let q = dot ap.u ap.v ap.w p.x p.y p.z in
  let g = dot f.gx f.gy f.gz p.x p.y p.z in
  let g' =
    dot_error f.gx f.gy f.gz p.x p.y p.z g +. dot f.gx f.gy f.gz p'.x p'.y p'.z
  in
  let s = q +. (2. *. g) in
  let t = s +. f.k in
  two_sum t
    (sum_error q (2. *. g) s
    +. sum_error s f.k t +. rest ap p p' q +. (2. *. g'))

let along_exactly f p d =
  let open Expansion in
  let num = of_float in
  let row a b c (v : vec) =
    add (mul (num a) v.x) (add (mul (num b) v.y) (mul (num c) v.z))
  in
  let times v =
    {
      x = row f.axx f.axy f.axz v;
      y = row f.axy f.ayy f.ayz v;
      z = row f.axz f.ayz f.azz v;
    }
  in
  let g = { x = num f.gx; y = num f.gy; z = num f.gz } in
  let ap = times p in
  let gp = dot g p in
  ( dot d (times d),
    add (dot d ap) (dot g d),
    add (add (dot p ap) (add gp gp)) (num f.k) )

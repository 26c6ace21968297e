open Candor_space

type t =
  | Matrix of float array
  | Form of { a : float array; b : Vec.t; c : float }
  | Plane of { normal : Vec.t; offset : float }
  | Ellipsoid of { center : Point.t; radii : Vec.t }
  | Cylinder of { from : Point.t; until : Point.t; radius : float }
  | Cone of { apex : Point.t; base : Point.t; radius : float }
  | Paraboloid of { apex : Point.t; base : Point.t; radius : float }
  | Hyperbolic_paraboloid of { center : Point.t; radii : Vec.t }
  | Hyperboloid_one_sheet of { center : Point.t; radii : Vec.t }
  | Hyperboloid_two_sheets of { center : Point.t; radii : Vec.t }
[@@deriving show, eq, ord]

(* {1 Checking} *)

let symmetric n q =
  let at i j = q.((n * i) + j) in
  let same i j = Float.equal (at i j) (at j i) in
  List.for_all
    (fun i -> List.for_all (same i) (List.init n Fun.id))
    (List.init n Fun.id)

let positive (r : Vec.t) = r.x > 0. && r.y > 0. && r.z > 0.
let radii_error = "the radii must be above 0"
let size_ok x = Float.abs x >= 0x1p-400 && Reach.length x

(* Squares of larger or smaller coefficients would leave the range of doubles;
   the constant term goes with the square of lengths. *)
let check_coefficients coefficients constant =
  let largest =
    Array.fold_left (fun m x -> Float.max m (Float.abs x)) 0. coefficients
  in
  if not (Reach.length largest && Float.abs constant <= 0x1p800) then
    Error Reach.message
  else if largest > 0. && largest < 0x1p-400 then
    Error "the largest coefficient must not be below 2^-400"
  else Ok ()

let check_axial from until radius =
  let axis = Point.sub until from in
  if not (Reach.point from && Reach.point until && Reach.length radius) then
    Error Reach.message
  else if not (radius > 0.) then Error "the radius must be above 0"
  else if not (Vec.norm axis >= 0x1p-400 && size_ok radius) then
    Error "the two ends must be apart, and the radius not below 2^-400"
  else Ok ()

let check_radii center (radii : Vec.t) =
  if not (Reach.point center && Reach.vec radii) then Error Reach.message
  else if not (positive radii) then Error radii_error
  else if not (size_ok radii.x && size_ok radii.y && size_ok radii.z) then
    Error "the radii must not be below 2^-400"
  else Ok ()

let check = function
  | Matrix q ->
      if Array.length q <> 16 then Error "a matrix has 16 numbers"
      else if not (Array.for_all Float.is_finite q) then Error Reach.message
      else if not (symmetric 4 q) then
        Error "the matrix is not symmetric: qij and qji must be equal"
      else check_coefficients (Array.sub q 0 15) q.(15)
  | Form { a; b; c } ->
      if Array.length a <> 9 then Error "the form's a has 9 numbers"
      else if
        not
          (Array.for_all Float.is_finite a
          && Vec.is_finite b && Float.is_finite c)
      then Error Reach.message
      else if not (symmetric 3 a) then
        Error "the form's a is not symmetric: aij and aji must be equal"
      else check_coefficients (Array.append a [| b.x; b.y; b.z |]) c
  | Plane { normal; offset } ->
      if not (Reach.vec normal && Reach.length offset) then Error Reach.message
      else if Vec.equal normal Vec.zero then Error "the normal must not be zero"
      else Ok ()
  | Cylinder { from; until; radius } -> check_axial from until radius
  | Cone { apex; base; radius } | Paraboloid { apex; base; radius } ->
      check_axial apex base radius
  | Ellipsoid { center; radii }
  | Hyperbolic_paraboloid { center; radii }
  | Hyperboloid_one_sheet { center; radii }
  | Hyperboloid_two_sheets { center; radii } ->
      check_radii center radii

(* {1 Extent} *)

type ends = { first : Point.t; second : Point.t; radius : float }

let ends = function
  | Cylinder { from; until; radius } ->
      Some { first = from; second = until; radius }
  | Cone { apex; base; radius } | Paraboloid { apex; base; radius } ->
      Some { first = apex; second = base; radius }
  | Matrix _ | Form _ | Plane _ | Ellipsoid _ | Hyperbolic_paraboloid _
  | Hyperboloid_one_sheet _ | Hyperboloid_two_sheets _ ->
      None

let bounds = function
  | Ellipsoid { center; radii } ->
      Bounds.widen 0.
        (Bounds.v (Point.add center (Vec.neg radii)) (Point.add center radii))
  | Cylinder { from = p; until = q; radius }
  | Cone { apex = p; base = q; radius }
  | Paraboloid { apex = p; base = q; radius } ->
      (* The double coefficients are off by a few ulp; so is the reach. *)
      let reach = radius *. (1. +. 0x1p-40) in
      let far = Vec.norm (Point.sub q p) *. 0x1p-40 in
      Bounds.widen (reach +. far) (Bounds.of_points [ p; q ])
  | Matrix _ | Form _ | Plane _ | Hyperbolic_paraboloid _
  | Hyperboloid_one_sheet _ | Hyperboloid_two_sheets _ ->
      Bounds.everything

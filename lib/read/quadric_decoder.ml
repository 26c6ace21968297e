open Candor_surface
open Decode
open Fields
open Geometry_decoder

let matrix =
  Quantity.numbers
    "Q11 Q12 Q13 Q14 Q21 Q22 Q23 Q24 Q31 Q32 Q33 Q34 Q41 Q42 Q43 Q44"
    Rule.length
  |> map (fun q -> Quadric_shape.Matrix q)

let form =
  fields
    (let+ a =
       field "a"
         (Quantity.numbers "A11 A12 A13 A21 A22 A23 A31 A32 A33" Rule.length)
     and+ b = field "b" vector
     and+ c = field "c" (length "C") in
     Quadric_shape.Form { a; b; c })

let plane =
  fields
    (let+ normal = field "normal" direction
     and+ offset = field "offset" (length "D") in
     Quadric_shape.Plane { normal; offset })

let cylinder =
  fields
    (let+ from = field "from" point
     and+ until = field "to" point
     and+ radius = field "radius" (size "R") in
     Quadric_shape.Cylinder { from; until; radius })

let tapered shape =
  fields
    (let+ apex = field "apex" point
     and+ base = field "base" point
     and+ radius = field "radius" (size "R") in
     shape ~apex ~base ~radius)

let centred shape =
  fields
    (let+ center = field "center" point and+ radii = field "radii" radii in
     shape ~center ~radii)

let shape =
  let open Quadric_shape in
  let cone ~apex ~base ~radius = Cone { apex; base; radius } in
  let paraboloid ~apex ~base ~radius = Paraboloid { apex; base; radius } in
  let ellipsoid ~center ~radii = Ellipsoid { center; radii } in
  let saddle ~center ~radii = Hyperbolic_paraboloid { center; radii } in
  let one_sheet ~center ~radii = Hyperboloid_one_sheet { center; radii } in
  let two_sheets ~center ~radii = Hyperboloid_two_sheets { center; radii } in
  choice "shape"
    [
      ("matrix", matrix);
      ("form", form);
      ("plane", plane);
      ("ellipsoid", centred ellipsoid);
      ("cylinder", cylinder);
      ("cone", tapered cone);
      ("paraboloid", tapered paraboloid);
      ("hyperbolic-paraboloid", centred saddle);
      ("hyperboloid-one-sheet", centred one_sheet);
      ("hyperboloid-two-sheets", centred two_sheets);
    ]

let quadric =
  let+ shape = item "shape" shape
  and+ clip = optional "clip" bounds
  and+ caps = present "caps" in
  Quadric.make ?clip ~caps shape

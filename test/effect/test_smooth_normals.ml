open Candor_oracle
open Called

let triangle more = "(triangle (0 0 0) (1 0 0) (0 1 0) " ^ more ^ ")"
let normals = "(normals (0 0 1) (1 0 1) (0 0 1))"

let calls () =
  check "with normals" Smooth_normals
    [ camera; triangle normals ]
    [ ("triangle with normals", 3) ];
  check "without" Smooth_normals [ camera; triangle "" ] [];
  check "within groups" Smooth_normals
    [ camera; "(group (group"; triangle normals; "))" ]
    [ ("triangle with normals", 4) ]

let suite =
  ("smooth normals", [ Law.example "triangles with normals call" calls ])

open Candor_oracle
open Called

let triangle more = "(triangle (0 0 0) (1 0 0) (0 1 0) " ^ more ^ ")"
let normals = "(normals (0 0 1) (1 0 1) (0 0 1))"

let calls () =
  check "with normals" Smooth_normals
    [ camera; triangle normals ]
    [ ("triangle with normals", 3) ];
  check "without" Smooth_normals [ camera; triangle "" ] [];
  let mesh normal =
    Filename.temp_file "candor" ".obj" |> fun path ->
    Out_channel.with_open_bin path (fun c ->
        Printf.fprintf c "v 0 0 0\nv 1 0 0\nv 0 1 0\n%s\n" normal);
    path
  in
  let of_mesh what normal reasons =
    let path = mesh normal in
    Fun.protect
      ~finally:(fun () -> Sys.remove path)
      (fun () ->
        let form = Printf.sprintf "(mesh %S)" path in
        check what Smooth_normals [ camera; form ] reasons)
  in
  of_mesh "a mesh with them" "vn 0 0 1\nf 1//1 2//1 3//1"
    [ ("mesh with normals", 3) ];
  of_mesh "a mesh without" "f 1 2 3" [];
  check "within groups" Smooth_normals
    [ camera; "(group (group"; triangle normals; "))" ]
    [ ("triangle with normals", 4) ]

let suite =
  ("smooth normals", [ Law.example "triangles with normals call" calls ])

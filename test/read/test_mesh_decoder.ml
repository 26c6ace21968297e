open Candor_space
open Candor_scene
open Candor_read
open Text

let obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 2\nf 1 3 4\n"

let written forms f =
  Files.with_folder (fun folder ->
      let path = Files.write folder "a.obj" obj in
      ignore (Files.write folder "more.scene" "(mesh \"a.obj\")" : string);
      f path
        (Scene_file.of_string
           ~name:(Filename.concat folder "test.scene")
           (scene forms)))

let shapes (s : Scene.t) =
  List.map
    (fun (s : Scene.surface) ->
      match s.shape with
      | Mesh { file; triangles; dropped } ->
          Printf.sprintf "%s: %d, %d dropped" file (Array.length triangles)
            dropped
      | Sphere _ | Box _ | Triangle _ | Quadric _ | Polygon _ | Group _ | Use _
        ->
          "something else")
    s.surfaces

let read forms f =
  written forms (fun _ -> function
    | Ok s -> f s
    | Error report -> Alcotest.fail (show report))

let beside () =
  read "(mesh a.obj) (include \"more.scene\")" (fun s ->
      Alcotest.(check (list string))
        "meshes"
        [ "a.obj: 2, 1 dropped"; "a.obj: 2, 1 dropped" ]
        (shapes s);
      match List.map (fun (s : Scene.surface) -> s.shape) s.surfaces with
      | [ Mesh a; Mesh b ] -> is "read once" true (a.triangles == b.triangles)
      | _ -> Alcotest.fail "not two meshes")

let attributes () =
  read "(mesh \"a.obj\" (motion 1 0 0) (material (mirror)) (both-sides))"
    (fun s ->
      let s = List.hd s.surfaces in
      is "motion" true (Vec.equal s.motion (Vec.v 1. 0. 0.));
      is "material" true (Option.is_some s.material);
      is "both sides" true s.both_sides)

let printed () =
  Files.with_folder (fun folder ->
      let name = Filename.concat folder "test.scene" in
      ignore (Files.write folder "a.obj" obj : string);
      let read text =
        match Scene_file.of_string ~name text with
        | Ok s -> s
        | Error report -> Alcotest.fail (show report)
      in
      let s =
        read (scene "(mesh \"a.obj\") (group (mesh \"a.obj\" (both-sides)))")
      in
      is "reads as printed" true (same s (read (Scene_printer.to_string s))))

let formats () =
  let check path expected = Meshes.refused Mesh_decoder.load expected path in
  check "a.stl" "unknown extension \".stl\": expected .obj or .ply";
  check "b/a" "\"a\" has no extension: expected .obj or .ply";
  check "nowhere.OBJ" "there is no such file";
  Files.with_folder (fun folder ->
      let path = Files.write folder "a.Ply" obj in
      check path "line 1: a PLY file begins with `ply`")

let suite =
  ( "mesh decoder",
    [
      case "a mesh is beside the file that names it, and read once" beside;
      case "a mesh has the fields of any surface" attributes;
      case "formats are told by the name" formats;
      case "a mesh reads as it was printed" printed;
    ] )

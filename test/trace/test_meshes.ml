(* A mesh is a group of triangles: whatever a ray sees of one, it sees of the
   other. *)

open Candor_space
open Candor_surface
open Candor_scene
open Candor_oracle
open Candor_scene_made

let with_file text f =
  let path = Filename.temp_file "candor" ".obj" in
  Out_channel.with_open_bin path (fun c -> Out_channel.output_string c text);
  Fun.protect ~finally:(fun () -> Sys.remove path) (fun () -> f path)

(* A tent with a flap, which has normals, and a face without area. *)
let obj =
  "v -1 -1 0\n\
   v 1 -1 0\n\
   v 1 1 0\n\
   v -1 1 0\n\
   v 0 0 1\n\
   vn 0 0 1\n\
   vn 1 0 1\n\
   vn -1 0 1\n\
   f 1 2 5\n\
   f 2 3 5\n\
   f 1 1 5\n\
   f 3 4 5\n\
   f 4//3 1//1 5//2\n"

let triangles =
  [
    "(-1 -1 0) (1 -1 0) (0 0 1)";
    "(1 -1 0) (1 1 0) (0 0 1)";
    "(1 1 0) (-1 1 0) (0 0 1)";
    "(-1 1 0) (-1 -1 0) (0 0 1) (normals (-1 0 1) (0 0 1) (1 0 1))";
  ]

(* [each] is a field of every triangle. *)
let group ~each fields =
  let triangle t = Printf.sprintf "(triangle %s %s)" t each in
  Printf.sprintf "(group %s %s)"
    (String.concat " " (List.map triangle triangles))
    fields

let lit =
  [
    Written.size 24 18;
    "(camera (perspective (eye 1 2 6) (look-at 0 0 0) (fov-y 40) (shutter 0 \
     1)))";
    "(render (spp 4))";
    "(background .2)";
    "(light (point (at 3 5 4) (intensity 60)))";
    "(quadric (plane (normal 0 1 0) (offset -1.2)))";
  ]

let both ?(each = "") fields f =
  with_file obj (fun path ->
      let mesh = Printf.sprintf "(mesh %S %s %s)" path each fields in
      let scene surface = Written.scene (lit @ [ surface ]) in
      f (scene mesh) (scene (group ~each fields)))

let same name ?each fields =
  both ?each fields (fun a b ->
      match Shot.difference (Shot.picture a) (Shot.picture b) with
      | None -> ()
      | Some where -> Alcotest.failf "%s: %s" name where)

let pictures () =
  same "matte" "";
  same "mirror" "(material (mirror))";
  same "translucent"
    "(material (translucent (index 1.3) (scattering 2) (absorption .1)))";
  same "emitting" "(material (emitter (radiance 3)))";
  same "emitting from both sides" ~each:"(both-sides)"
    "(material (emitter (radiance 3)))";
  same "moving" "(motion .5 0 0)"

let hit scene =
  let surface = Assembly.surface ~dress:Fun.id scene in
  fun ray ->
    Surface.nearest surface ray
    |> Option.map (fun (h : _ Hit.t) -> (h.path, Int64.bits_of_float h.t))

let paths () =
  both "" (fun a b ->
      let mesh = hit a and group = hit b in
      let seen = Hashtbl.create 16 in
      for i = -10 to 10 do
        for j = -10 to 10 do
          let x = float_of_int i /. 8. and y = float_of_int j /. 8. in
          let ray =
            Ray.v (Point.v x y 5.) (Vec.v (0.01 *. y) (0.02 *. x) (-1.))
          in
          let found = mesh ray in
          Option.iter (fun (p, _) -> Hashtbl.replace seen p ()) found;
          Alcotest.(check (option (pair (list int) int64)))
            "hit" (group ray) found
        done
      done;
      List.iter
        (fun i ->
          Alcotest.(check bool)
            (Printf.sprintf "1.%d is seen" i)
            true
            (Hashtbl.mem seen [ 1; i ]))
        [ 0; 1; 2; 3 ])

let suite =
  ( "meshes",
    [
      Law.example "a mesh is met in the places of a group's triangles" paths;
      Law.example "a mesh looks like a group of its triangles, bit for bit"
        pictures;
    ] )

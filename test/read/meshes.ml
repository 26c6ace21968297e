(* Meshes as the texts that they read like. *)

open Candor_surface
open Candor_read

let triangle (t : Triangle.t) =
  let point (p : Candor_space.Point.t) = Printf.sprintf "(%g %g %g)" p.x p.y p.z
  and vec (v : Candor_space.Vec.t) = Printf.sprintf "(%g %g %g)" v.x v.y v.z in
  let { Triangle.a; b; c } = t.corners in
  let normals (a, b, c) = " n" ^ vec a ^ vec b ^ vec c
  and uv (t : Triangle.uv) =
    Printf.sprintf " t(%g %g)(%g %g)(%g %g)" t.ua t.va t.ub t.vb t.uc t.vc
  in
  point a ^ point b ^ point c
  ^ Option.fold t.normals ~none:"" ~some:normals
  ^ Option.fold t.uv ~none:"" ~some:uv

let shown (m : Faces.t) =
  Printf.sprintf "%d dropped" m.dropped
  :: List.map triangle (Array.to_list m.triangles)

let check name read expected text =
  Alcotest.(check (result (list string) string))
    name (Ok expected)
    (Result.map shown (read text))

let refused read expected text =
  Alcotest.(check (result (list string) string))
    text (Error expected)
    (Result.map shown (read text))

(* [text] cut short everywhere, and with each byte changed: an error is one line,
   never an exception. *)
let survives read text =
  let try_ text =
    match read text with
    | Ok (_ : Faces.t) -> ()
    | Error why ->
        if why = "" || String.contains why '\n' then
          Alcotest.failf "%S: %S" text why
  in
  String.iteri
    (fun i c ->
      try_ (String.sub text 0 i);
      let change by =
        let changed = Bytes.of_string text in
        Bytes.set changed i (Char.chr (Char.code c lxor by));
        try_ (Bytes.to_string changed)
      in
      List.iter change [ 1; 2; 4; 8; 16; 32; 64; 128; 255 ])
    text

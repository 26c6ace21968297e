(* What the library makes of every family beside the exact truth.

   figures.exe [CASES] [KIND] *)

open Candor_space
open Candor_surface
open Candor_oracle
open Candor_surface_families

let count =
  match Array.to_list Sys.argv with
  | _ :: n :: _ -> int_of_string n
  | _ -> 10000

let wanted name =
  match Array.to_list Sys.argv with
  | [ _; _; kind ] -> String.equal kind name
  | _ -> true

let table name kind families =
  if wanted name then (
    Family.heading name;
    List.iter (Family.figures kind ~count) families)

(* How far a spawned ray starts from the hit, in units of 2^-53 of the sum of
   the hit's coordinates. *)
let offsets name surface families =
  let sizes { Family.name; cases } =
    let rand = Random.State.make [| Law.seed; Hashtbl.hash name |] in
    let offset { Family.shape; ray } =
      Option.map
        (fun (h : unit Hit.t) ->
          let { Point.x; y; z } = h.point in
          let size = Float.abs x +. Float.abs y +. Float.abs z in
          h.offset /. (0x1p-53 *. size))
        (Surface.nearest (surface shape) ray)
    in
    let found =
      List.filter_map offset (QCheck2.Gen.generate ~rand ~n:count cases)
    in
    Printf.printf "%-64s %s\n%!" name (Family.spread (Array.of_list found))
  in
  if wanted "offsets" then (
    Printf.printf "%-64s %s\n"
      ("offsets, in u of coordinates: " ^ name)
      "     p50     p99      max";
    List.iter sizes families)

let () =
  table "sphere" Spheres.kind Spheres.all;
  table "box" Boxes.kind Boxes.all;
  table "triangle" Triangles.kind Triangles.all;
  table "quadric" Quadrics.kind Quadrics.all;
  offsets "sphere" (fun s -> Surface.sphere s ()) Spheres.all;
  offsets "box" (fun b -> Surface.box b ()) Boxes.all;
  offsets "triangle" (fun s -> Surface.triangle s ()) Triangles.all;
  offsets "quadric" (fun q -> Surface.quadric q ()) Quadrics.all

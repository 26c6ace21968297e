(* What the library makes of every family beside the exact truth.

   figures.exe [CASES] [KIND] *)

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

let () =
  table "sphere" Spheres.kind Spheres.all;
  table "box" Boxes.kind Boxes.all;
  table "triangle" Triangles.kind Triangles.all;
  table "quadric" Quadrics.kind Quadrics.all

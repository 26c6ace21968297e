open Candor_space
open Candor_surface
open Candor_scene
open Decode
open Fields
open Geometry_decoder

(* {1 What every surface has} *)

let attributes =
  let+ material = optional "material" Material_decoder.use
  and+ motion = default "motion" vector Vec.zero
  and+ both_sides = present "both-sides" in
  fun shape place -> { Scene.shape; material; motion; both_sides; place }

(* [surface wrap shape] is a surface with the fields of [shape]. *)
let surface wrap shape =
  let surface =
    let+ shape = shape and+ attributes = attributes in
    Result.map (fun shape -> attributes (wrap shape)) shape
  in
  fields surface |> check Fun.id |> placed

(* {1 Kinds} *)

let sphere =
  let+ center = field "center" point and+ radius = field "radius" (size "R") in
  Sphere.make ~center ~radius

let box =
  let+ min = field "min" point and+ max = field "max" point in
  Box.make ~min ~max

let uv =
  let of_corners (a, b, c) : Triangle.uv =
    { ua = a.(0); va = a.(1); ub = b.(0); vb = b.(1); uc = c.(0); vc = c.(1) }
  in
  triple (Quantity.numbers "U V" Rule.length) |> map of_corners

let triangle =
  let+ corners = items (tuple point)
  and+ normals = optional "normals" (triple direction)
  and+ uv = optional "uv" uv in
  match corners with
  | [ a; b; c ] -> Triangle.make ?normals ?uv { a; b; c }
  | [] | [ _ ] | [ _; _ ] | _ :: _ :: _ :: _ :: _ ->
      Error
        (Printf.sprintf "three corners (X Y Z) are needed, not %d"
           (List.length corners))

let polygon =
  let+ corners = items (tuple point) in
  Polygon.make corners

let transform = default "transform" Transform_decoder.steps []

let group surface =
  let+ transform = transform and+ surfaces = items surface in
  Ok (transform, surfaces)

let use =
  fields
    (let+ transform = transform and+ attributes = attributes in
     (transform, attributes))
  |> referring Definition
  |> map (fun (name, (transform, attributes)) ->
      attributes (Scene.Use { transform; name }))
  |> placed

let mesh = Mesh_decoder.mesh (fields attributes) |> placed

let cases_of any =
  let grouped (transform, surfaces) = Scene.Group { transform; surfaces } in
  [
    ("sphere", surface (fun s -> Scene.Sphere s) sphere);
    ("box", surface (fun s -> Scene.Box s) box);
    ("triangle", surface (fun s -> Scene.Triangle s) triangle);
    ("quadric", surface (fun s -> Scene.Quadric s) Quadric_decoder.quadric);
    ("polygon", surface (fun s -> Scene.Polygon s) polygon);
    ("mesh", mesh);
    ("group", surface grouped (group any));
    ("use", use);
  ]

let any = fix (fun any -> choice "surface" (cases_of any))
let cases = cases_of any

let definition =
  let some surfaces =
    if List.is_empty surfaces then Error "at least one surface is needed"
    else Ok surfaces
  in
  fields (items any) |> check some |> named

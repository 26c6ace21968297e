open Candor_space
open Candor_surface

type t = { triangles : Triangle.t array; dropped : int }

type corner = {
  at : Point.t;
  uv : (float * float) option;
  normal : Vec.t option;
}

type building = {
  found : Triangle.t Dynarray.t;
  mutable faces : int;
  mutable without_area : int;
}

let corner ?uv ?normal at =
  let is_turned n = not (Vec.equal n Vec.zero) in
  let normal =
    match normal with
    | Some n when is_turned n -> normal
    | Some _ | None -> None
  in
  { at; uv; normal }

let start () = { found = Dynarray.create (); faces = 0; without_area = 0 }

let triangle a b c =
  let normals =
    match (a.normal, b.normal, c.normal) with
    | Some a, Some b, Some c -> Some (a, b, c)
    | None, _, _ | _, None, _ | _, _, None -> None
  and uv =
    match (a.uv, b.uv, c.uv) with
    | Some (ua, va), Some (ub, vb), Some (uc, vc) ->
        Some { Triangle.ua; va; ub; vb; uc; vc }
    | None, _, _ | _, None, _ | _, _, None -> None
  in
  Result.to_option (Triangle.make ?normals ?uv { a = a.at; b = b.at; c = c.at })

(* {1 More than three corners} *)

(* The way from the first corner to each, in units of a power of two as large as
   the face, so that its size decides nothing. *)
let ways corners =
  let way c = Point.sub c.at corners.(0).at in
  let ways = Array.map way corners in
  let larger m way = Float.max m (Vec.largest way) in
  let _, exponent = Float.frexp (Array.fold_left larger 0. ways) in
  let unit x = Float.ldexp x (-exponent) in
  Array.map (fun (a : Vec.t) -> Vec.v (unit a.x) (unit a.y) (unit a.z)) ways

(* [wedge ways i] spans the face from its first corner to [i] and the next. *)
let wedge ways i = Vec.cross ways.(i) ways.(i + 1)

let for_all_between first last p =
  let rec from i = i > last || (p i && from (i + 1)) in
  from first

let is_convex ways normal =
  let n = Array.length ways in
  let side i = Vec.sub ways.((i + 1) mod n) ways.(i mod n) in
  let turns_left i = Vec.dot normal (Vec.cross (side i) (side (i + 1))) > 0. in
  let opens i = Vec.dot normal (wedge ways i) > 0. in
  for_all_between 0 (n - 1) turns_left && for_all_between 1 (n - 2) opens

let fan n = List.init (n - 2) (fun i -> (0, i + 1, i + 2))

module Places = Map.Make (Point)

(* The triangles as seen along the axis that the face faces most, as numbers of
   corners; none if they have others. *)
let cut ways normal =
  let size i = Float.abs (Vec.get normal i) in
  let x = size 0 and y = size 1 and z = size 2 in
  let flat (a : Vec.t) =
    if x >= y && x >= z then Point.v 0. a.y a.z
    else if y >= z then Point.v a.x 0. a.z
    else Point.v a.x a.y 0.
  in
  let seen = List.map flat (Array.to_list ways) in
  let name places (i, p) =
    if Places.mem p places then places else Places.add p i places
  in
  let names =
    List.fold_left name Places.empty (List.mapi (fun i p -> (i, p)) seen)
  in
  let numbers (t : Triangle.t) =
    let find p = Places.find_opt p names in
    match (find t.corners.a, find t.corners.b, find t.corners.c) with
    | Some a, Some b, Some c -> Some (a, b, c)
    | None, _, _ | _, None, _ | _, _, None -> None
  in
  match Polygon.make seen with
  | Error _ -> None
  | Ok p ->
      let found = List.filter_map numbers p.triangles in
      if List.compare_lengths found p.triangles = 0 then Some found else None

let pieces corners =
  let n = Array.length corners in
  if n <= 3 then fan n
  else
    let ways = ways corners in
    let add sum i = Vec.add sum (wedge ways i) in
    let normal = Seq.fold_left add Vec.zero (Seq.init (n - 1) Fun.id) in
    if is_convex ways normal then fan n
    else Option.value (cut ways normal) ~default:(fan n)

(* {1 The whole} *)

let add b corners =
  let before = Dynarray.length b.found in
  let piece (i, j, k) =
    triangle corners.(i) corners.(j) corners.(k)
    |> Option.iter (Dynarray.add_last b.found)
  in
  List.iter piece (pieces corners);
  b.faces <- b.faces + 1;
  if Dynarray.length b.found = before then b.without_area <- b.without_area + 1

let finish b =
  if b.faces = 0 then Error "the file has no faces"
  else if Dynarray.is_empty b.found then Error "no face of the file has an area"
  else Ok { triangles = Dynarray.to_array b.found; dropped = b.without_area }

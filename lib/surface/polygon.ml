open Candor_number
open Candor_space

type t = { corners : Point.t list; triangles : Triangle.t list }
[@@deriving show, eq, ord]

(* Not [Vec.cross], which cancels where a polygon is thin. *)
let cross (a : Vec.t) (b : Vec.t) =
  let minor = Error_free.difference_of_products in
  Vec.v (minor a.y b.z a.z b.y) (minor a.z b.x a.x b.z) (minor a.x b.y a.y b.x)

(* The way from the mean of the corners to each, in units of the greatest power
   of two within the polygon's extent. Taking differences from a corner first
   keeps polygons far from the origin as flat as they are. *)
let spokes exponent corner corners =
  let near p =
    let a = Point.sub p corner in
    let unit x = Float.ldexp x (-exponent) in
    Vec.v (unit a.x) (unit a.y) (unit a.z)
  in
  let ways = List.map near corners in
  let sum = List.fold_left Vec.add Vec.zero ways in
  let mean = Vec.scale (1. /. float_of_int (List.length ways)) sum in
  List.map (fun way -> Vec.sub way mean) ways

(* Newell's normal, but for parts that run the other way round, as in a bow-tie:
   they are turned over, lest they cancel the rest. *)
let normal spokes =
  let next = match spokes with [] -> [] | first :: rest -> rest @ [ first ] in
  let swept = List.map2 cross spokes next in
  let wider a b = if Vec.norm b > Vec.norm a then b else a in
  let widest = List.fold_left wider Vec.zero swept in
  let add n a = if Vec.dot a widest < 0. then Vec.sub n a else Vec.add n a in
  List.fold_left add Vec.zero swept

(* The number of the corner farthest from the plane, and how far it is. *)
let outlier normal spokes =
  let n =
    Option.value (normal : Dir.t option :> Vec.t option) ~default:Vec.zero
  in
  let farther (worst, most) (i, spoke) =
    let distance = Float.abs (Vec.dot n spoke) in
    if distance > most then (i, distance) else (worst, most)
  in
  List.fold_left farther (0, 0.) (List.mapi (fun i s -> (i + 1, s)) spokes)

let axes normal =
  let across i = Float.abs (Vec.get normal i) in
  List.sort (fun i j -> Float.compare (across j) (across i)) [ 0; 1; 2 ]

(* The triangles as seen along an axis, none if nothing is seen of the area.
   Those are left out that only their being seen on the grid turned over: they
   are thinner than its squares, and their neighbours overlap there. *)
let filled corners axis =
  let view = Flat.view ~axis corners in
  let see = Flat.see view in
  let outline = List.map see corners in
  let facing = Flat.facing outline in
  let triangle ((a : Flat.t), (b : Flat.t), (c : Flat.t)) =
    let a = a.place and b = b.place and c = c.place in
    if Flat.turn (see a) (see b) (see c) <= 0 then None
    else
      let b, c = if facing < 0 then (c, b) else (b, c) in
      Result.to_option (Triangle.make { a; b; c })
  in
  if facing = 0 then []
  else
    List.filter_map triangle
      (Filling.triangles (Border.of_outline view outline))

let extent corners =
  let bounds = Bounds.of_points corners in
  Vec.largest (Point.sub (Bounds.high bounds) (Bounds.low bounds))

let fill corner corners =
  let size, exponent = Float.frexp (extent corners) in
  let spokes = spokes exponent corner corners in
  let normal = normal spokes in
  let worst, distance = outlier (Dir.of_vec normal) spokes in
  let has_area axis =
    match filled corners axis with [] -> None | triangles -> Some triangles
  in
  if distance > 0x1p-40 *. size then
    Error (Printf.sprintf "corner %d is off the plane of the others" worst)
  else
    match List.find_map has_area (axes normal) with
    | Some triangles -> Ok { corners; triangles }
    | None -> Error "the polygon has no area"

let make corners =
  if not (List.for_all Reach.point corners) then Error Reach.message
  else
    match List.sort_uniq Point.compare corners with
    | [] | [ _ ] | [ _; _ ] ->
        Error "a polygon needs at least three different corners"
    | corner :: _ -> fill corner corners

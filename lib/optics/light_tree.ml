open Candor_space

type light = { bounds : Bounds.t; power : float }

(* Lights next to each other, seen from afar; [size] is half the diagonal,
   squared. *)
type cluster = { x : float; y : float; z : float; size : float; power : float }

type node =
  | Leaf of { first : int; count : int }
  | Fork of {
      middle : int; (* where the second part begins in the order *)
      left : cluster;
      right : cluster;
      first : node;
      second : node;
    }

type t = { order : int array; root : node }
type leaf = { first : int; count : int; probability : float; rest : float }

let order t = t.order

(* {1 Making} *)

let half x y = (0.5 *. x) +. (0.5 *. y)

let center (b : Bounds.t) =
  Point.v (half b.x0 b.x1) (half b.y0 b.y1) (half b.z0 b.z1)

let cluster (lights : light array) order first count =
  let bounds = ref Bounds.empty and power = ref 0. in
  for i = first to first + count - 1 do
    let light = lights.(order.(i)) in
    bounds := Bounds.join !bounds light.bounds;
    power := !power +. light.power
  done;
  let ({ Point.x; y; z } as c) = center !bounds in
  let reach = Point.sub (Bounds.high !bounds) c in
  { x; y; z; size = Vec.dot reach reach; power = !power }

(* The axis along which the centres are furthest apart. *)
let longest centers order first count =
  let points = List.init count (fun i -> centers.(order.(first + i))) in
  let b = Bounds.of_points points in
  let x = b.x1 -. b.x0 and y = b.y1 -. b.y0 and z = b.z1 -. b.z0 in
  if x >= y && x >= z then 0 else if y >= z then 1 else 2

let sort centers order first count =
  let axis = longest centers order first count in
  let along i = Point.get centers.(i) axis in
  let part = Array.sub order first count in
  let before i j =
    match Float.compare (along i) (along j) with 0 -> Int.compare i j | c -> c
  in
  Array.stable_sort before part;
  Array.blit part 0 order first count

let make (lights : light array) =
  let count = Array.length lights in
  let centers = Array.map (fun (l : light) -> center l.bounds) lights in
  (* Local mutation: sorted part by part while the tree is made. *)
  let order = Array.init count Fun.id in
  let rec node first count ~most =
    if count <= most then Leaf { first; count }
    else (
      sort centers order first count;
      let half = count / 2 in
      let middle = first + half and rest = count - half in
      Fork
        {
          middle;
          left = cluster lights order first half;
          right = cluster lights order middle rest;
          first = node first half ~most;
          second = node middle rest ~most;
        })
  in
  { root = node 0 count ~most:(if count <= 32 then 32 else 8); order }

(* {1 Choosing} *)

let weight c (p : Point.t) =
  let x = p.x -. c.x and y = p.y -. c.y and z = p.z -. c.z in
  let squared = (x *. x) +. (y *. y) +. (z *. z) in
  c.power /. if squared > c.size then squared else c.size

(* Never 0 or 1, so that no light is ruled out by rounding, or by a power that
   is not known. *)
let share a b p =
  let wa = weight a p and wb = weight b p in
  let s = wa /. (wa +. wb) in
  if s >= 0x1p-10 then if s <= 1. -. 0x1p-10 then s else 1. -. 0x1p-10
  else if s < 0x1p-10 then 0x1p-10
  else 0.5

let sample t ~from u =
  let rec down node probability u =
    match node with
    | Leaf { first; count } -> { first; count; probability; rest = u }
    | Fork { left; right; first; second; _ } ->
        let s = share left right from in
        if u < s then down first (probability *. s) (u /. s)
        else down second (probability *. (1. -. s)) ((u -. s) /. (1. -. s))
  in
  let leaf = down t.root 1. u in
  if leaf.rest < 1. then leaf else { leaf with rest = Float.pred 1. }

let find t ~from i =
  let rec down node probability =
    match node with
    | Leaf { first; count } -> { first; count; probability; rest = 0. }
    | Fork { middle; left; right; first; second } ->
        let s = share left right from in
        if i < middle then down first (probability *. s)
        else down second (probability *. (1. -. s))
  in
  down t.root 1.

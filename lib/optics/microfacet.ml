open Candor_space

(* Of a unit vector at cosine [c], the length when its part across the normal is
   shrunk by alpha: Smith's functions are ratios of this and [c]. *)
let[@inline] stretch alpha c =
  sqrt ((c *. c) +. (alpha *. alpha *. (1. -. (c *. c))))

let rec distribution ~alpha ~(normal : Dir.t) h =
  let n = (normal :> Vec.t) in
  let length2 = Vec.dot h h and along = Vec.dot n h in
  if not (along > 0.) then 0.
  else if length2 < 0x1p-400 then
    match Dir.of_vec h with
    | None -> 0.
    | Some d -> distribution ~alpha ~normal (d :> Vec.t)
  else
    let across = Vec.cross n h and alpha2 = alpha *. alpha in
    let spread =
      length2 /. ((alpha2 *. along *. along) +. Vec.dot across across)
    in
    alpha2 *. spread *. spread /. Float.pi

let lambda ~alpha c =
  if not (c > 0.) then infinity
  else alpha *. alpha *. (1. -. (c *. c)) /. (2. *. c *. (c +. stretch alpha c))

let masking ~alpha c = if c > 0. then 2. *. c /. (c +. stretch alpha c) else 0.

(* With s = [stretch], 1 + lambda c is (1 + s/c) / 2. *)
let[@inline] crossed alpha c c' =
  (c *. stretch alpha c') +. (c' *. stretch alpha c)

let shared_masking ~alpha c c' =
  if c > 0. && c' > 0. then 2. *. c *. c' /. crossed alpha c c' else 0.

let seen_again ~alpha c c' =
  if c' > 0. then c' *. (c +. stretch alpha c) /. crossed alpha c c' else 0.

let[@inline] cosine (normal : Dir.t) (d : Dir.t) =
  Vec.dot (normal :> Vec.t) (d :> Vec.t)

let[@inline] half (view : Dir.t) (toward : Dir.t) =
  Vec.add (view :> Vec.t) (toward :> Vec.t)

let reflection ~alpha ~normal ~view ~toward =
  let c = cosine normal view and c' = cosine normal toward in
  if c > 0. && c' > 0. then
    distribution ~alpha ~normal (half view toward) /. (2. *. crossed alpha c c')
  else 0.

let visible ~alpha ~normal ~view ~(half : Dir.t) =
  let c = cosine normal view and facing = cosine view half in
  if facing > 0. then
    2. *. facing
    *. distribution ~alpha ~normal (half :> Vec.t)
    /. (c +. stretch alpha c)
  else 0.

let density ~alpha ~normal ~view ~toward =
  let c = cosine normal view in
  if c > 0. && cosine normal toward > 0. then
    distribution ~alpha ~normal (half view toward)
    /. (2. *. (c +. stretch alpha c))
  else 0.

(* Shrunk across the normal, the mirrors become a hemisphere, and what it
   reflects is spread evenly over the part of the sphere above -view. Heights are
   kept as distances from the ends of that part: nothing cancels. *)
let seen ~alpha (view : Vec.t) ~u ~v =
  let x = alpha *. view.x and y = alpha *. view.y in
  let length = sqrt ((x *. x) +. (y *. y) +. (view.z *. view.z)) in
  let x = x /. length and y = y /. length in
  let extent = 1. +. (view.z /. length) in
  let below_top = v *. extent in
  let radius = sqrt (Float.abs (below_top *. (2. -. below_top))) in
  let turn = 2. *. Float.pi *. u in
  let x = alpha *. (x +. (radius *. cos turn))
  and y = alpha *. (y +. (radius *. sin turn))
  and z = (1. -. v) *. extent in
  let length = sqrt ((x *. x) +. (y *. y) +. (z *. z)) in
  Vec.v (x /. length) (y /. length) (z /. length)

open Candor_space

type 'a t = {
  tree : Tree.t;
  items : 'a array; (* in the order of the leaves, then those outside *)
  index : int array; (* where each stood in the array given *)
  unbounded : int; (* how many of the last items are outside of the tree *)
  whole : Bounds.t;
}

let bounds h = h.whole

type kind = Absent | Bounded | Unbounded

let kind (b : Bounds.t) =
  if b.x0 > b.x1 then Absent
  else if Bounds.is_finite b then Bounded
  else Unbounded

let make ~bounds items =
  let n = Array.length items in
  let boxes = Box_array.create n in
  let whole = ref Bounds.empty in
  let measure i item =
    let b = bounds item in
    Box_array.set boxes i b;
    whole := Bounds.join !whole b;
    kind b
  in
  let kinds = Array.mapi measure items in
  let places wanted =
    let place i k = if k = wanted then Some i else None in
    Array.of_seq (Seq.filter_map Fun.id (Seq.mapi place (Array.to_seq kinds)))
  in
  let tree = Tree.build boxes (places Bounded) and outside = places Unbounded in
  let index = Array.append tree.order outside in
  {
    tree;
    items = Array.map (fun i -> items.(i)) index;
    index;
    unbounded = Array.length outside;
    whole = !whole;
  }

(* {1 Visiting} *)

(* The ray, with the reciprocals that the slab test multiplies by. Where its
   origin is known by a double and a rest, near ends are seen from as far on as
   the rest may reach, far ends from as far back. *)
type probe = {
  near_ox : float;
  near_oy : float;
  near_oz : float;
  far_ox : float;
  far_oy : float;
  far_oz : float;
  ix : float;
  iy : float;
  iz : float;
}

(* A visit under way. *)
type ('a, 'context) walk = {
  boxes : Box_array.t;
  links : int array;
  hierarchy : 'a t;
  probe : probe;
  cursor : Cursor.t;
  context : 'context;
  test : 'context -> int -> 'a -> bool;
}

(* Each end of a slab is off by at most three roundings (M. Pharr, W. Jakob, G.
   Humphreys, Physically Based Rendering, 4th ed., 6.8), and the t of a hit by
   some ulps: widening the far end by more makes the test conservative. Below
   the normal numbers rounding is absolute. *)
let far_factor = 1. +. 0x1p-48
let far_more = 0x1p-1070

(* A reciprocal that overflows would make the ray parallel to the axis; nan
   leaves the axis out. *)
let[@inline] reciprocal d =
  let i = 1. /. d in
  if Float.abs i <= 0x1.fffffffffffffp1023 || d = 0. then i else nan

(* Once an interval is not, no further axis makes it so. *)
let[@inline] in_order t0 t1 = t0 <= t1 || t0 <= (t1 *. far_factor) +. far_more

(* The ray enters a slab at its low end if it rises, else at its high end.
   Comparisons are written so that a nan (the origin in a face, the ray along
   it) leaves the interval as it was, on every axis. *)
let[@inline] meets w n =
  let b = w.boxes and p = w.probe in
  let n = 6 * n in
  let near, far =
    let low = Float.Array.unsafe_get b n
    and high = Float.Array.unsafe_get b (n + 1) in
    if p.ix >= 0. then ((low -. p.near_ox) *. p.ix, (high -. p.far_ox) *. p.ix)
    else ((high -. p.near_ox) *. p.ix, (low -. p.far_ox) *. p.ix)
  in
  let t0 = if near > 0. then near else 0.
  and t1 = if far < w.cursor.t then far else w.cursor.t in
  let near, far =
    let low = Float.Array.unsafe_get b (n + 2)
    and high = Float.Array.unsafe_get b (n + 3) in
    if p.iy >= 0. then ((low -. p.near_oy) *. p.iy, (high -. p.far_oy) *. p.iy)
    else ((high -. p.near_oy) *. p.iy, (low -. p.far_oy) *. p.iy)
  in
  let t0 = if near > t0 then near else t0
  and t1 = if far < t1 then far else t1 in
  in_order t0 t1
  &&
  let near, far =
    let low = Float.Array.unsafe_get b (n + 4)
    and high = Float.Array.unsafe_get b (n + 5) in
    if p.iz >= 0. then ((low -. p.near_oz) *. p.iz, (high -. p.far_oz) *. p.iz)
    else ((high -. p.near_oz) *. p.iz, (low -. p.far_oz) *. p.iz)
  in
  let t0 = if near > t0 then near else t0
  and t1 = if far < t1 then far else t1 in
  in_order t0 t1

let[@inline] descending p axis =
  not ((if axis = 0 then p.ix else if axis = 1 then p.iy else p.iz) >= 0.)

let rec visit_items w from until =
  from < until
  && (w.test w.context
        (Array.unsafe_get w.hierarchy.index from)
        (Array.unsafe_get w.hierarchy.items from)
     || visit_items w (from + 1) until)

let rec visit_node w n =
  meets w n
  &&
  let link = Array.unsafe_get w.links n in
  if Tree.is_leaf link then
    let first = Tree.first link in
    visit_items w first (first + Tree.count link)
  else if descending w.probe (Tree.axis link) then
    visit_node w (Tree.high_child link) || visit_node w (n + 1)
  else visit_node w (n + 1) || visit_node w (Tree.high_child link)

(* The same, open nodes being passed through. Boxes hold those below them, also
   as [meets] rounds: which items are tested hangs on the boxes of leaves alone. *)
let rec visit_open w n =
  let link = Array.unsafe_get w.links n in
  if Tree.is_leaf link then
    meets w n
    &&
    let first = Tree.first link in
    visit_items w first (first + Tree.count link)
  else
    (Tree.is_open link || meets w n)
    &&
    if descending w.probe (Tree.axis link) then
      visit_open w (Tree.high_child link) || visit_open w (n + 1)
    else visit_open w (n + 1) || visit_open w (Tree.high_child link)

(* How far along its axis the rest of an origin [o] may reach. *)
let[@inline] rest o i =
  let e = 0x1p-51 *. Float.abs o in
  if i >= 0. then e else -.e

let probe (ray : Object_ray.t) =
  let o = ray.origin and d = ray.direction in
  let ix = reciprocal d.x and iy = reciprocal d.y and iz = reciprocal d.z in
  if ray.exact then
    {
      near_ox = o.x;
      near_oy = o.y;
      near_oz = o.z;
      far_ox = o.x;
      far_oy = o.y;
      far_oz = o.z;
      ix;
      iy;
      iz;
    }
  else
    let ex = rest o.x ix and ey = rest o.y iy and ez = rest o.z iz in
    {
      near_ox = o.x +. ex;
      near_oy = o.y +. ey;
      near_oz = o.z +. ez;
      far_ox = o.x -. ex;
      far_oy = o.y -. ey;
      far_oz = o.z -. ez;
      ix;
      iy;
      iz;
    }

let visit h probe cursor context test =
  let { boxes; links; _ } : Tree.t = h.tree in
  let w = { boxes; links; hierarchy = h; probe; cursor; context; test } in
  let n = Array.length h.items in
  visit_items w (n - h.unbounded) n
  || Array.length links > 0
     && if Tree.may_be_open h.tree then visit_open w 0 else visit_node w 0

(* {1 In parts} *)

let cover h ~depth =
  let rec parts depth n rest =
    let link = h.tree.links.(n) in
    if depth <= 0 || Tree.is_leaf link then Box_array.get h.tree.boxes n :: rest
    else
      parts (depth - 1) (n + 1) (parts (depth - 1) (Tree.high_child link) rest)
  in
  if h.unbounded > 0 then [ h.whole ]
  else if Array.length h.tree.links = 0 then []
  else parts depth 0 []

type t = { boxes : Box_array.t; links : int array; order : int array }

(* A leaf's link is first * 16 + count; an inner node's is the complement of
   high child * 8 + axis, and 4 more if it is open, which is negative. *)
let leaf ~first ~count = (first lsl 4) lor count

let inner ~high ~axis ~is_open =
  lnot ((high lsl 3) lor (if is_open then 4 else 0) lor axis)

let[@inline] is_leaf l = l >= 0
let[@inline] first l = l lsr 4
let[@inline] count l = l land 15
let[@inline] is_open l = l land 4 = 0
let[@inline] high_child l = lnot l lsr 3
let[@inline] axis l = lnot l land 3
let bins = 16
let most_in_leaf = 4

(* What meeting a node costs, in units of testing one item. *)
let node_cost = 0.5

(* Where there are no more items than this, a node of at least this part of the
   area of the last one that was met is met so often that its children may as well
   be met at once. Among more items, what was hit before often spares it. *)
let most_in_open = 16
let open_part = 0.6

(* Deeper than this, items are divided by number. *)
let sah_depth = 40

(* Local mutation: all of this is filled while one tree is built. *)
type builder = {
  items : Box_array.t;
  order : int array;
  nodes : Box_array.t;
  links : int array;
  mutable size : int; (* nodes so far *)
  bin_boxes : Box_array.t;
  bin_counts : int array;
  costs_above : floatarray;
  scratch : Box_array.t;
}

let middle = 0
let running = 1

let measure b n first count =
  Box_array.clear b.nodes n;
  Box_array.clear b.scratch middle;
  for i = first to first + count - 1 do
    Box_array.grow b.nodes n b.items b.order.(i);
    Box_array.grow_by_center b.scratch middle b.items b.order.(i)
  done

(* The bins of a node divide the box of its items' centres along one axis. *)
type division = { axis : int; low : float; scale : float }

let bin b { axis; low; scale } item =
  let k = int_of_float ((Box_array.center b.items item axis -. low) *. scale) in
  if k < 0 then 0 else if k >= bins then bins - 1 else k

let fill_bins b division first count =
  for k = 0 to bins - 1 do
    Box_array.clear b.bin_boxes k;
    b.bin_counts.(k) <- 0
  done;
  for i = first to first + count - 1 do
    let item = b.order.(i) in
    let k = bin b division item in
    Box_array.grow b.bin_boxes k b.items item;
    b.bin_counts.(k) <- b.bin_counts.(k) + 1
  done

let running_cost b unit n =
  Box_array.half_area b.scratch running ~unit *. float_of_int n

(* The last bin of the low part, and the cost of dividing there in units of the
   node's area times one item. *)
let best_boundary b n count =
  let unit = Box_array.extent b.nodes n (Box_array.widest b.nodes n) in
  Box_array.clear b.scratch running;
  let above = ref 0 in
  for k = bins - 1 downto 1 do
    Box_array.grow b.scratch running b.bin_boxes k;
    above := !above + b.bin_counts.(k);
    Float.Array.set b.costs_above (k - 1) (running_cost b unit !above)
  done;
  Box_array.clear b.scratch running;
  let best = ref (-1) and cost = ref infinity and below = ref 0 in
  for k = 0 to bins - 2 do
    Box_array.grow b.scratch running b.bin_boxes k;
    below := !below + b.bin_counts.(k);
    let c = running_cost b unit !below +. Float.Array.get b.costs_above k in
    if !below > 0 && !below < count && c < !cost then (
      best := k;
      cost := c)
  done;
  (!best, !cost /. Box_array.half_area b.nodes n ~unit)

(* Moves the items of bins up to [last] to the front; how many there are. *)
let partition b division last first count =
  let next = ref first in
  for i = first to first + count - 1 do
    let item = b.order.(i) in
    if bin b division item <= last then (
      b.order.(i) <- b.order.(!next);
      b.order.(!next) <- item;
      incr next)
  done;
  !next - first

(* How many items go to the low child; 0 if they should stay together. *)
let divide b n depth first count =
  let axis = Box_array.widest b.scratch middle in
  let spread = Box_array.extent b.scratch middle axis in
  let low = Box_array.low b.scratch middle axis in
  let scale = float_of_int bins /. spread in
  let division = { axis; low; scale } in
  let by_number = if count <= most_in_leaf then 0 else count / 2 in
  if depth > sah_depth || not (spread > 0. && scale < infinity) then
    (axis, by_number)
  else (
    fill_bins b division first count;
    let last, cost = best_boundary b n count in
    if last < 0 then (axis, by_number)
    else if count <= most_in_leaf && not (cost +. node_cost < float_of_int count)
    then (axis, 0)
    else (axis, partition b division last first count))

let has_few order = Array.length order <= most_in_open

let fills b n around =
  let unit =
    Box_array.extent b.nodes around (Box_array.widest b.nodes around)
  in
  let area n = Box_array.half_area b.nodes n ~unit in
  n <> around && area n >= open_part *. area around

(* [around] is the last node on the way here that is not open. *)
let rec node b ~around depth first count =
  let n = b.size in
  b.size <- n + 1;
  measure b n first count;
  match if count = 1 then (0, 0) else divide b n depth first count with
  | _, 0 -> b.links.(n) <- leaf ~first ~count
  | axis, below ->
      let is_open = has_few b.order && fills b n around in
      let around = if is_open then around else n in
      node b ~around (depth + 1) first below;
      b.links.(n) <- inner ~high:b.size ~axis ~is_open;
      node b ~around (depth + 1) (first + below) (count - below)

let build items order =
  let n = Array.length order in
  let b =
    {
      items;
      order;
      nodes = Box_array.create (2 * n);
      links = Array.make (2 * n) 0;
      size = 0;
      bin_boxes = Box_array.create bins;
      bin_counts = Array.make bins 0;
      costs_above = Float.Array.create bins;
      scratch = Box_array.create 2;
    }
  in
  if n > 0 then node b ~around:0 0 0 n;
  { boxes = b.nodes; links = Array.sub b.links 0 b.size; order }

let may_be_open (t : t) = has_few t.order

open Candor_number

(* [sums.(i)] is the sum of the weights before [i]; [last] is the last positive
   weight. The weights are scaled to be at most 1. *)
type t = { weights : floatarray; sums : floatarray; last : int; total : float }
type choice = { index : int; rest : float; probability : float }

let largest weights =
  Float.Array.fold_left (fun m w -> if w > m then w else m) 0. weights

(* Rounded from twice the precision, so they never fall. *)
let running weights =
  let sum = ref Running_sum.zero in
  let next w =
    sum := Running_sum.add !sum w;
    Running_sum.total !sum
  in
  let sums = Float.Array.make (Float.Array.length weights + 1) 0. in
  Float.Array.iteri (fun i w -> Float.Array.set sums (i + 1) (next w)) weights;
  sums

let rec last_positive weights i =
  if Float.Array.get weights i > 0. then i else last_positive weights (i - 1)

let of_scaled weights =
  let n = Float.Array.length weights in
  let sums = running weights in
  let total = Float.Array.get sums n in
  if total > 0. then
    Some { weights; sums; last = last_positive weights (n - 1); total }
  else None

(* By a power of two, so that sums do not overflow. *)
let scaled weights =
  let m = largest weights in
  let _, e = Float.frexp m in
  let scale w = if w > 0. then Float.ldexp w (-e) else 0. in
  if Float.is_finite m then Some (Float.Array.map scale weights) else None

let make weights = Option.bind (scaled weights) of_scaled
let length t = Float.Array.length t.weights

let probability t i =
  if 0 <= i && i < length t then Float.Array.get t.weights i /. t.total else 0.

(* The first index in lo..hi whose sum with its weight is above [x], or [hi]. *)
let rec find sums x lo hi =
  if lo >= hi then hi
  else
    let mid = (lo + hi) / 2 in
    if Float.Array.get sums (mid + 1) > x then find sums x lo mid
    else find sums x (mid + 1) hi

let sample t u =
  let x = u *. t.total in
  let index = find t.sums x 0 t.last in
  let from = Float.Array.get t.sums index in
  let rest = (x -. from) /. (Float.Array.get t.sums (index + 1) -. from) in
  let rest = if rest < 1. then rest else Float.pred 1. in
  { index; rest; probability = Float.Array.get t.weights index /. t.total }

type square = { columns : int; rows : t; cells : t option array }
type place = { u : float; v : float; density : float }

let row columns weights i =
  let first = i * columns in
  let weight j =
    if first + j < Float.Array.length weights then
      Float.Array.get weights (first + j)
    else 0.
  in
  of_scaled (Float.Array.init columns weight)

let total = function Some t -> t.total | None -> 0.

let of_scaled_cells columns weights =
  let length = (Float.Array.length weights + columns - 1) / columns in
  let cells = Array.init length (row columns weights) in
  let totals = Float.Array.init length (fun i -> total cells.(i)) in
  Option.map (fun rows -> { columns; rows; cells }) (of_scaled totals)

let square ~columns weights =
  Option.bind (scaled weights) (of_scaled_cells columns)

let area s = float_of_int (s.columns * length s.rows)

(* (i + rest)/n, kept below 1. *)
let within i rest n =
  Float.min ((float_of_int i +. rest) /. float_of_int n) (Float.pred 1.)

let place s { Pattern.u; v } =
  let row = sample s.rows v in
  match s.cells.(row.index) with
  | None -> { u; v; density = 0. }
  | Some cells ->
      let cell = sample cells u in
      {
        u = within cell.index cell.rest s.columns;
        v = within row.index row.rest (length s.rows);
        density = row.probability *. cell.probability *. area s;
      }

let cell n u = int_of_float (Float.floor (u *. float_of_int n))

let density s { Pattern.u; v } =
  let i = cell (length s.rows) v in
  if i < 0 || i >= length s.rows then 0.
  else
    match s.cells.(i) with
    | None -> 0.
    | Some cells ->
        probability s.rows i *. probability cells (cell s.columns u) *. area s

open Candor_sample

type part = All | Part of int

type likes = {
  pixels : float;
  classes : (float * float * float) list;
      (* of pixels that are alike, by their √(v/c): that, their number, the sum
         of v *)
}

type t = {
  window : Window.t;
  base : int;
  deviations : floatarray; (* √(v/c) of each pixel *)
  parts : likes array;
  all : likes;
  work : float;
}

let place (w : Window.t) i =
  let width = Window.width w in
  (w.x0 + (i mod width), w.y0 + (i / width))

let index (w : Window.t) x y = ((y - w.y0) * Window.width w) + x - w.x0

(* Of the pixels of each part. *)
let indices window =
  let lists = Array.make Part.count [] in
  for i = (Window.width window * Window.height window) - 1 downto 0 do
    let x, y = place window i in
    let part = Part.of_pixel x y in
    lists.(part) <- i :: lists.(part)
  done;
  lists

(* {1 What neighbours know} *)

(* The means of what some advisers of each pixel say; 1, which is as good as any
   number, where there are none. *)
let smooth (w : Window.t) values advisers =
  let advisers = Array.of_list advisers in
  let around i =
    let x, y = place w i in
    (* Local mutation: two sums. *)
    let sum = ref 0. and number = ref 0 in
    for k = 0 to Array.length advisers - 1 do
      let dx, dy = advisers.(k) in
      let x = x + dx and y = y + dy in
      if w.x0 <= x && x < w.x1 && w.y0 <= y && y < w.y1 then (
        sum := !sum +. Float.Array.get values (index w x y);
        incr number)
    done;
    if !number > 0 then !sum /. float_of_int !number else 1.
  in
  Float.Array.init (Float.Array.length values) around

(* {1 What to believe of it} *)

let mean_over indices f =
  let sum = List.fold_left (fun sum i -> sum +. f i) 0. indices in
  sum /. Float.max 1. (float_of_int (List.length indices))

(* How much of what sets these pixels apart is more than chance: what either
   half of their advisers says are two measurements of the same, and the mean of
   both is as reliable as follows from how far they agree (C. Spearman, Correlation
   Calculated from Faulty Data, British Journal of Psychology 3(3), 1910). *)
let reliability indices a b =
  let centred values =
    let get = Float.Array.get values in
    let mean = mean_over indices get in
    fun i -> get i -. mean
  in
  let a = centred a and b = centred b in
  let product f g = mean_over indices (fun i -> f i *. g i) in
  let scatter = sqrt (product a a *. product b b) in
  if scatter > 0. then
    let r = Float.max 0. (product a b /. scatter) in
    2. *. r /. (1. +. r)
  else 0.

(* As far as it is reliable; for the rest, pixels of a part are alike. So are
   they if nobody saw an error. *)
let believed indices roots (a, b) =
  let get = Float.Array.get roots in
  (* Local mutation: filled here. *)
  let result = Float.Array.copy roots in
  let of_part indices =
    let share = reliability indices a b and mean = mean_over indices get in
    let believe i =
      Float.Array.set result i
        (if mean > 0. then mean +. (share *. (get i -. mean)) else 1.)
    in
    List.iter believe indices
  in
  Array.iter of_part indices;
  result

(* {1 Classes of like pixels} *)

let per_octave = 8.
let class_of d = int_of_float (Float.floor (per_octave *. Float.log2 d))

let enter table key (n, d, v) =
  let n', d', v' =
    Option.value (Hashtbl.find_opt table key) ~default:(0., 0., 0.)
  in
  Hashtbl.replace table key (n +. n', d +. d', v +. v')

let of_table pixels table =
  let classes =
    Hashtbl.to_seq table |> List.of_seq
    |> List.sort (fun (a, _) (b, _) -> Int.compare a b)
    |> List.map (fun (_, (n, d, v)) -> (d /. n, n, v))
  in
  { pixels = float_of_int pixels; classes }

(* Local mutation: tables are filled here. *)
let classify window ~squares deviations =
  let table _ = Hashtbl.create 256 in
  let tables = Array.init Part.count table and all = table () in
  let pixels = Array.make Part.count 0 in
  let add i d =
    let x, y = place window i in
    let part = Part.of_pixel x y in
    pixels.(part) <- pixels.(part) + 1;
    if d > 0. then
      enter tables.(part) (class_of d) (1., d, Float.Array.get squares i)
  in
  Float.Array.iteri add deviations;
  Array.iter (Hashtbl.iter (enter all)) tables;
  ( Array.map2 of_table pixels tables,
    of_table (Float.Array.length deviations) all )

let mean_weighted ~by:weights values =
  let sum = Float.Array.fold_left ( +. ) 0. in
  sum (Float.Array.map2 ( *. ) weights values) /. sum weights

let make window ~base ~cost f =
  let over value =
    Float.Array.init
      (Window.width window * Window.height window)
      (fun i ->
        let x, y = place window i in
        value x y)
  in
  let finite v = if Float.is_finite v then v else 0. in
  let values = over (fun x y -> finite (f x y)) in
  let first, second = Part.advisers in
  let advisers = first @ second in
  let squares = smooth window values advisers in
  let roots of_some = Float.Array.map sqrt (smooth window values of_some) in
  let roots =
    believed (indices window)
      (Float.Array.map sqrt squares)
      (roots first, roots second)
  and costs = smooth window (over cost) advisers in
  let deviations = Float.Array.map2 (fun r c -> r /. sqrt c) roots costs in
  let parts, all = classify window ~squares deviations in
  let work = mean_weighted ~by:deviations costs in
  { window; base; deviations; parts; all; work }

let base a = a.base
let with_base a base = { a with base }
let work a = a.work

(* {1 Samples} *)

let real a ~scale ~most deviation =
  let n = scale *. deviation in
  let base = float_of_int a.base in
  if n <= base then base else Float.min n (float_of_int most)

(* Streams that fill their space evenly do so best with powers of two. *)
let samples a ~scale ~most x y =
  let deviation = Float.Array.get a.deviations (index a.window x y) in
  let n = real a ~scale ~most deviation in
  let chance = Key.float (Key.v ~seed:0 ~x ~y ~sample:0 ~bounce:0 Share) in
  let rec between low =
    let high = Int.min most (2 * low) in
    if high <= low then low
    else if float_of_int high <= n then between high
    else if chance *. float_of_int (high - low) < n -. float_of_int low then
      high
    else low
  in
  between a.base

(* {1 Together} *)

let likes a = function All -> a.all | Part i -> a.parts.(i)

let mean a part ~scale ~most =
  let likes = likes a part and base = float_of_int a.base in
  let more (deviation, n, _) = n *. (real a ~scale ~most deviation -. base) in
  let more = List.fold_left (fun sum c -> sum +. more c) 0. likes.classes in
  base +. (more /. Float.max 1. likes.pixels)

let error a ~law ~scale ~most =
  let base = float_of_int a.base in
  let left (deviation, _, v) =
    v *. ((base /. real a ~scale ~most deviation) ** law)
  in
  let sum f = List.fold_left (fun sum c -> sum +. f c) 0. a.all.classes in
  let all = sum (fun (_, _, v) -> v) in
  if all > 0. then sum left /. all else 0.

(* {1 Scales} *)

(* More would not tell scales apart. *)
let halvings = 32

(* The least scale that is [enough], between one that changes nothing and one
   that gives all pixels with an error the most. *)
let search a part ~most enough =
  let rec between low high n =
    if n = 0 then high
    else
      let middle = sqrt (low *. high) in
      if enough middle then between low middle (n - 1)
      else between middle high (n - 1)
  in
  let { classes; _ } = likes a part in
  match (classes, List.rev classes) with
  | (least, _, _) :: _, (largest, _, _) :: _ ->
      between
        (float_of_int a.base /. largest)
        (2. *. float_of_int most /. least)
        halvings
  | [], _ | _, [] -> 0.

let for_mean a part ~most n =
  search a part ~most (fun scale -> mean a part ~scale ~most >= n)

let for_error a ~law ~most share =
  search a All ~most (fun scale -> error a ~law ~scale ~most <= share)

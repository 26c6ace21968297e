open Candor_sample

type t = {
  width : int;
  base : int;
  deviations : floatarray; (* √v of each pixel *)
  classes : (float * float * float) list;
      (* of like pixels, by their √v: that, their number, the sum of v *)
}

(* {1 What neighbours know} *)

(* Binomial weights of five pixels each way. *)
let weights = [| 1.; 4.; 6.; 4.; 1. |]
let reach = 2

(* The weighted mean of the values around (x, y), without its own. *)
let around ~width ~height values x y =
  let rec across j i ((sum, all) as sums) =
    if i > reach then sums
    else
      let x = x + i and y = y + j in
      let inside = 0 <= x && x < width && 0 <= y && y < height in
      if (not inside) || (i = 0 && j = 0) then across j (i + 1) sums
      else
        let w = weights.(i + reach) *. weights.(j + reach) in
        let v = Float.Array.get values ((y * width) + x) in
        across j (i + 1) (sum +. (w *. v), all +. w)
  in
  let rec down j sums =
    if j > reach then sums else down (j + 1) (across j (-reach) sums)
  in
  let sum, all = down (-reach) (0., 0.) in
  if all > 0. then sum /. all else 1.

(* {1 Classes of like pixels} *)

let per_octave = 16.

let classify values =
  (* Local mutation: the table is filled here. *)
  let table = Hashtbl.create 256 in
  let add v =
    if v > 0. then
      let key = int_of_float (Float.floor (per_octave *. Float.log2 v)) in
      let n, sum = Option.value (Hashtbl.find_opt table key) ~default:(0, 0.) in
      Hashtbl.replace table key (n + 1, sum +. v)
  in
  Float.Array.iter add values;
  let of_class (_, (n, sum)) =
    let n = float_of_int n in
    (sqrt (sum /. n), n, sum)
  in
  Hashtbl.to_seq table |> List.of_seq
  |> List.sort (fun (a, _) (b, _) -> Int.compare a b)
  |> List.map of_class

let make ~width ~height ~base f =
  let value i =
    let v = f (i mod width) (i / width) in
    if Float.is_finite v then v else 0.
  in
  let values = Float.Array.init (width * height) value in
  let smooth =
    Float.Array.init (width * height) (fun i ->
        around ~width ~height values (i mod width) (i / width))
  in
  {
    width;
    base;
    deviations = Float.Array.map sqrt smooth;
    classes = classify smooth;
  }

(* {1 Samples} *)

let real a ~scale ~most deviation =
  let n = scale *. deviation in
  let base = float_of_int a.base in
  if n <= base then base else Float.min n (float_of_int most)

(* Streams that fill their space evenly do so best with powers of two. *)
let samples a ~scale ~most x y =
  let deviation = Float.Array.get a.deviations ((y * a.width) + x) in
  let n = real a ~scale ~most deviation in
  let chance = Key.float (Key.v ~seed:0 ~x ~y ~sample:0 ~bounce:0 Film) in
  let rec between low =
    let high = Int.min most (2 * low) in
    if high <= low then low
    else if float_of_int high <= n then between high
    else if chance *. float_of_int (high - low) < n -. float_of_int low then
      high
    else low
  in
  between a.base

let total a ~scale ~most =
  let base = float_of_int a.base in
  let more (deviation, n, _) = n *. (real a ~scale ~most deviation -. base) in
  let least = base *. float_of_int (Float.Array.length a.deviations) in
  List.fold_left (fun sum c -> sum +. more c) least a.classes

let error a ~law ~scale ~most =
  let base = float_of_int a.base in
  let left (deviation, _, v) =
    v *. ((base /. real a ~scale ~most deviation) ** law)
  in
  let sum f = List.fold_left (fun sum c -> sum +. f c) 0. a.classes in
  let all = sum (fun (_, _, v) -> v) in
  if all > 0. then sum left /. all else 0.

(* {1 Scales} *)

(* The least scale that is [enough], between one that changes nothing and one
   that gives all pixels with an error the most. *)
let search a ~most enough =
  let rec between low high n =
    if n = 0 then high
    else
      let middle = sqrt (low *. high) in
      if enough middle then between low middle (n - 1)
      else between middle high (n - 1)
  in
  match (a.classes, List.rev a.classes) with
  | (least, _, _) :: _, (largest, _, _) :: _ ->
      between
        (float_of_int a.base /. largest)
        (2. *. float_of_int most /. least)
        60
  | [], _ | _, [] -> 0.

let for_error a ~law ~most share =
  search a ~most (fun scale -> error a ~law ~scale ~most <= share)

let for_total a ~most n =
  search a ~most (fun scale -> total a ~scale ~most >= n)

(* Random numbers of every size, points, colours and odd names. *)

open Candor_space
open Candor_colour
open Candor_surface

type 'a draw = Random.State.t -> 'a

let one_of (l : 'a draw list) : 'a draw =
 fun r -> List.nth l (Random.State.int r (List.length l)) r

let const x : 'a draw = fun _ -> x
let int low high : int draw = fun r -> low + Random.State.int r (high - low + 1)
let map f (d : 'a draw) : 'b draw = fun r -> f (d r)
let bool : bool draw = Random.State.bool

let option (d : 'a draw) : 'a option draw =
 fun r -> if bool r then Some (d r) else None

let list ?(least = 0) n (d : 'a draw) : 'a list draw =
 fun r -> List.init (int least n r) (fun _ -> d r)

(* {1 Numbers} *)

let uniform low high : float draw =
 fun r -> low +. Random.State.float r (high -. low)

let bits : float draw = map Int64.float_of_bits (fun r -> Random.State.bits64 r)

let coordinate : float draw =
 fun r ->
  let x =
    one_of
      [
        map float_of_int (int (-9) 9);
        map (fun n -> float_of_int n /. 10.) (int (-99) 99);
        uniform (-10.) 10.;
        bits;
        const (-0.);
        const 0x1p-1074;
      ]
      r
  in
  if Reach.length x then x else 1.

let size : float draw =
 fun r ->
  let x = Float.abs (coordinate r) in
  if x >= 0x1p-400 && x <= 0x1p400 then x else 0.5

let share = one_of [ const 0.; const 1.; const 0.1; uniform 0. 1. ]

let light_number : float draw =
 fun r ->
  let x = Float.abs (bits r) in
  if Float.is_finite x then x else 3.

let point r =
  let x = coordinate r in
  let y = coordinate r in
  Point.v x y (coordinate r)

let vec r = Point.sub (point r) Point.origin

let direction r =
  let v = vec r in
  if Vec.equal v Vec.zero then Vec.v 0. 0. 1. else v

let near_point r =
  let x = uniform (-9.) 9. r in
  let y = uniform (-9.) 9. r in
  Point.v x y (uniform (-9.) 9. r)

let rgb d r =
  let a = d r in
  if bool r then Rgb.grey a
  else
    let b = d r in
    Rgb.v a b (d r)

let name : string draw =
  one_of
    [
      (fun r -> Printf.sprintf "name%d" (int 0 999 r));
      (fun r -> String.init (int 0 5 r) (fun _ -> Char.chr (int 1 255 r)));
      one_of
        (List.map const
           [
             "";
             "(";
             "a b";
             "\"q\"";
             ";x";
             "#|";
             "|#";
             "\\";
             "5";
             "scene";
             "#;";
             "a\nb";
             "\xc3\xa4";
           ]);
    ]

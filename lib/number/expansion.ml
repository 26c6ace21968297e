(* The parts from the smallest up, none zero, their bits not overlapping. *)
type t = float list

let of_float x = if x = 0. then [] else [ x ]
let neg = List.map Float.neg
let cons lo rest = if lo = 0. then rest else lo :: rest

let rec grow b = function
  | [] -> of_float b
  | e :: rest ->
      let { Error_free.hi; lo } = Error_free.two_sum b e in
      cons lo (grow hi rest)

let add a b = List.fold_left (fun sum x -> grow x sum) a b
let sub a b = add a (neg b)
let diff a b = add (of_float a) (of_float (-.b))

let scale k a =
  let product x =
    let { Error_free.hi; lo } = Error_free.two_product k x in
    cons lo (of_float hi)
  in
  List.fold_left (fun sum x -> add sum (product x)) [] a

let shift e = List.map (fun x -> Float.ldexp x e)
let mul a b = List.fold_left (fun sum x -> add sum (scale x b)) [] a
let rec last = function [] -> 0. | [ x ] -> x | _ :: rest -> last rest
let sign a = Float.compare (last a) 0.

(* Smallest first, so every sum but the last is of numbers far apart. *)
let to_float a = List.fold_left ( +. ) 0. a

let to_pair a =
  let hi = to_float a in
  Error_free.two_sum hi (to_float (sub a (of_float hi)))

let ratio a b =
  let x = to_float a and y = to_float b in
  let q = x /. y in
  if Float.is_finite q then
    let rest = to_float (sub a (scale q b)) in
    q +. (rest /. y)
  else q

let ratio_pair a b =
  let q = ratio a b in
  let rest = if Float.is_finite q then ratio (sub a (scale q b)) b else 0. in
  Error_free.two_sum q rest

type vec = { x : t; y : t; z : t }

let dot a b = add (mul a.x b.x) (add (mul a.y b.y) (mul a.z b.z))

let cross a b =
  {
    x = sub (mul a.y b.z) (mul a.z b.y);
    y = sub (mul a.z b.x) (mul a.x b.z);
    z = sub (mul a.x b.y) (mul a.y b.x);
  }

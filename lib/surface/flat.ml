open Candor_number
open Candor_space

type t = { u : float; v : float; place : Point.t }
type view = { axis : int; u_exponent : int; v_exponent : int }

let coordinate axis i p = Point.get p ((axis + i) mod 3)

let view ~axis points =
  let exponent i =
    let larger m p = Float.max m (Float.abs (coordinate axis i p)) in
    snd (Float.frexp (List.fold_left larger 0. points))
  in
  { axis; u_exponent = exponent 1; v_exponent = exponent 2 }

(* What is not 0 is then a multiple of 2^-502, and a product of two one of
   2^-1004: nothing underflows, so [turn] is exact. *)
let clean x = if Float.abs x < 0x1p-450 then 0. else x

let see { axis; u_exponent; v_exponent } place =
  let near_one i exponent = Float.ldexp (coordinate axis i place) (-exponent) in
  {
    u = clean (near_one 1 u_exponent);
    v = clean (near_one 2 v_exponent);
    place;
  }

let compare a b =
  match Float.compare a.u b.u with 0 -> Float.compare a.v b.v | order -> order

let equal a b = compare a b = 0

(* {1 Exact decisions} *)

let area a b c =
  let open Expansion in
  sub (mul (diff a.u c.u) (diff b.v c.v)) (mul (diff a.v c.v) (diff b.u c.u))

(* The sign of the area if it surely is beyond [reach], or 0. The error bound is
   [ccwerrboundA] of J. R. Shewchuk, Adaptive Precision Floating-Point Arithmetic
   and Fast Robust Geometric Predicates, 1997. *)
let[@inline] clear_turn reach a b c =
  let plus = (a.u -. c.u) *. (b.v -. c.v)
  and minus = (a.v -. c.v) *. (b.u -. c.u) in
  let error = 0x1.8000000000002p-52 *. (Float.abs plus +. Float.abs minus) in
  if plus -. minus > reach +. error then 1
  else if minus -. plus > reach +. error then -1
  else 0

let turn a b c =
  match clear_turn 0. a b c with 0 -> Expansion.sign (area a b c) | way -> way

let facing = function
  | [] -> 0
  | first :: rest ->
      let add (total, early, a) b =
        let swept = area first a b in
        let early = if early = 0 then Expansion.sign swept else early in
        (Expansion.add total swept, early, b)
      in
      let start = (Expansion.of_float 0., 0, first) in
      let total, early, _ = List.fold_left add start rest in
      let way = Expansion.sign total in
      if way = 0 then early else way

(* {1 The grid} *)

let nearest x =
  let steps = 0x1p53 *. x in
  let below = Float.floor steps in
  0x1p-53 *. if steps -. below < 0.5 then below else below +. 1.

let to_grid a = { a with u = nearest a.u; v = nearest a.v }

let crossing { axis; u_exponent; v_exponent } (a, b) (c, d) =
  let near = area c d a and far = area c d b in
  let whole = Expansion.sub far near in
  let at get =
    let part p weight = Expansion.(mul (of_float (get p)) weight) in
    Expansion.(ratio (sub (part a far) (part b near)) whole)
  and within get x =
    let low p q = Float.min (get p) (get q)
    and high p q = Float.max (get p) (get q) in
    Float.max
      (Float.max (low a b) (low c d))
      (Float.min x (Float.min (high a b) (high c d)))
  in
  let seen get = within get (nearest (at get)) in
  let u = seen (fun p -> p.u) and v = seen (fun p -> p.v) in
  let place i =
    match (i - axis + 3) mod 3 with
    | 1 -> Float.ldexp u u_exponent
    | 2 -> Float.ldexp v v_exponent
    | _ -> at (fun p -> Point.get p.place i)
  in
  { u; v; place = Point.v (place 0) (place 1) (place 2) }

(* A line meets the square if it parts the outermost two corners on either side
   of it. Of these the square holds only the lower left one, which the line may
   touch from below where it falls. *)
let enters (a, b) p =
  let wide = b.u -. a.u and high = Float.abs (b.v -. a.v) in
  let parts () =
    let open Expansion in
    let falls = b.v < a.v in
    let high = if falls then diff a.v b.v else diff b.v a.v in
    let reach = mul (of_float 0x1p-54) (add (diff b.u a.u) high) in
    let swept = area a b p in
    let over = sign (sub swept reach) in
    (over < 0 || (over = 0 && falls)) && sign (add swept reach) > 0
  in
  Float.min a.v b.v <= p.v
  && p.v <= Float.max a.v b.v
  && clear_turn (0x1p-53 *. (wide +. high)) a b p = 0
  && parts ()

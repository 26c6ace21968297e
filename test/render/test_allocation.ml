open Candor_render
open Candor_oracle
open QCheck2

(* {1 Pictures of errors} *)

type case = {
  width : int;
  height : int;
  base : int;
  most : int;
  squares : float array;
}

let squares =
  Gen.oneof
    [
      Draw.uniform 0. 10.;
      Draw.wide (-20.) 4.;
      Draw.pick [ 0.; 0.; nan; infinity ];
    ]

let case =
  let open Gen in
  let* width = int_range 1 12 and* height = int_range 1 10 in
  let* base = Draw.pick [ 1; 4; 8; 32 ] in
  let* most =
    oneof [ pure base; int_range base (64 * base); pure (1 lsl 30) ]
  in
  let+ squares =
    oneof
      [
        array_size (pure (width * height)) squares;
        array_size (pure (width * height)) (Draw.uniform 1. 9.);
        pure (Array.make (width * height) 0.);
        pure (Array.make (width * height) 3.);
      ]
  in
  { width; height; base; most; squares }

let show c =
  Printf.sprintf "%dx%d from %d to %d: %s" c.width c.height c.base c.most
    (String.concat " "
       (List.map (Printf.sprintf "%h") (Array.to_list c.squares)))

let make ?(squares = fun c i -> c.squares.(i)) c =
  Allocation.make ~width:c.width ~height:c.height ~base:c.base (fun x y ->
      squares c ((y * c.width) + x))

let places c =
  List.init (c.width * c.height) (fun i -> (i mod c.width, i / c.width))

let scale = Gen.oneof [ Draw.wide (-6.) 12.; Draw.pick [ 0.; 1. ] ]

let law ?count name gen print f =
  Law.law ?count
    ~print:(fun (c, x) -> Printf.sprintf "%s; %s" (show c) (print x))
    name (Gen.pair case gen) f

let one = Printf.sprintf "%h"
let two (a, b) = Printf.sprintf "%h, %h" a b

(* {1 Its laws} *)

let within (c, scale) =
  let a = make c in
  List.for_all
    (fun (x, y) ->
      let n = Allocation.samples a ~scale ~most:c.most x y in
      c.base <= n && n <= c.most)
    (places c)

let monotone (c, (s, t)) =
  let a = make c and low = Float.min s t and high = Float.max s t in
  let samples scale (x, y) = Allocation.samples a ~scale ~most:c.most x y in
  List.for_all (fun p -> samples low p <= samples high p) (places c)
  && Allocation.total a ~scale:low ~most:c.most
     <= Allocation.total a ~scale:high ~most:c.most *. (1. +. 0x1p-40)
  && Allocation.error a ~law:1. ~scale:high ~most:c.most
     <= Allocation.error a ~law:1. ~scale:low ~most:c.most *. (1. +. 0x1p-40)

(* Whatever else is found in a pixel, its own number is the same: this is why
   its mean is right on average. *)
let own_left_out (c, (scale, (k, other))) =
  let i = k mod (c.width * c.height) in
  let changed c j = if j = i then other else c.squares.(j) in
  let samples a =
    Allocation.samples a ~scale ~most:c.most (i mod c.width) (i / c.width)
  in
  samples (make c) = samples (make ~squares:changed c)

(* Its neighbours', two each way, is another. *)
let neighbours_told () =
  let at x y f =
    let a = Allocation.make ~width:9 ~height:9 ~base:4 f in
    Allocation.samples a ~scale:100. ~most:1_000_000 x y
  in
  let plain _ _ = 1. in
  let bright x0 y0 x y = if x = x0 && y = y0 then 1e6 else 1. in
  for y = 0 to 8 do
    for x = 0 to 8 do
      let near = abs (x - 4) <= 2 && abs (y - 4) <= 2 in
      let told = at x y (bright 4 4) > at x y plain in
      Alcotest.(check bool)
        (Printf.sprintf "pixel %d %d" x y)
        (near && not (x = 4 && y = 4))
        told
    done
  done

let again (c, scale) =
  let samples () =
    let a = make c in
    List.map
      (fun (x, y) -> Allocation.samples a ~scale ~most:c.most x y)
      (places c)
  in
  let forwards = samples () in
  let backwards =
    let a = make c in
    List.rev_map
      (fun (x, y) -> Allocation.samples a ~scale ~most:c.most x y)
      (List.rev (places c))
  in
  forwards = backwards && forwards = samples ()

(* {1 Sums} *)

let counts c a scale =
  let samples (x, y) = Allocation.samples a ~scale ~most:c.most x y in
  List.map (fun p -> float_of_int (samples p)) (places c)

let sum = List.fold_left ( +. ) 0.

(* Classes are a sixteenth of an octave of squares wide, which moves a root by
   2.2 %. Between powers of two a coin decides, of which each pixel has one:
   what that adds has a deviation of half the number or less. *)
let counted (c, scale) =
  let a = make c in
  let total = Allocation.total a ~scale ~most:c.most in
  let counts = counts c a scale in
  let deviation = 0.5 *. sqrt (sum (List.map (fun n -> n *. n) counts)) in
  Float.abs (sum counts -. total) <= (0.023 *. total) +. (5. *. deviation)
  || Law.fail "%g, but %g were announced" (sum counts) total

let ends (c, _) =
  let a = make c in
  let pixels = float_of_int (c.width * c.height) in
  let base = float_of_int c.base *. pixels in
  Allocation.total a ~scale:0. ~most:c.most = base
  &&
  let greatest = Allocation.for_total a ~most:c.most infinity in
  let none = Allocation.error a ~law:1. ~scale:0. ~most:c.most = 0. in
  (Allocation.error a ~law:1. ~scale:0. ~most:c.most = if none then 0. else 1.)
  && greatest = Allocation.for_error a ~law:1. ~most:c.most (-1.)
  && Float.is_finite greatest
  && List.for_all
       (fun (x, y) ->
         let n = Allocation.samples a ~scale:greatest ~most:c.most x y in
         n = c.most || n = c.base)
       (places c)

let inverts_total (c, share) =
  let a = make c and most = c.most in
  let low = Allocation.total a ~scale:0. ~most in
  let high =
    Allocation.total a ~scale:(Allocation.for_total a ~most infinity) ~most
  in
  let n = low +. (share *. (high -. low)) in
  let scale = Allocation.for_total a ~most n in
  let found = Allocation.total a ~scale ~most in
  Float.abs (found -. n) <= 1e-6 *. n
  || Law.fail "%g instead of %g, of %g to %g" found n low high

let inverts_error (c, (share, law)) =
  let a = make c and most = c.most in
  let error scale = Allocation.error a ~law ~scale ~most in
  let low = error (Allocation.for_error a ~law ~most (-1.)) in
  let high = error 0. in
  let wanted = low +. (share *. (high -. low)) in
  let found = error (Allocation.for_error a ~law ~most wanted) in
  Float.abs (found -. wanted) <= 1e-6 *. wanted
  || Law.fail "%g instead of %g, of %g to %g" found wanted low high

(* Where pixels have equal errors, they have equal shares; where one half has
   four times the error of the other, twice as many. *)
let shares () =
  let a =
    Allocation.make ~width:200 ~height:100 ~base:4 (fun x _ ->
        if x < 100 then 4. else 1.)
  in
  let scale = Allocation.for_total a ~most:1000 (30. *. 20_000.) in
  let mean x0 =
    let sum = ref 0 in
    for y = 0 to 99 do
      for x = x0 to x0 + 49 do
        sum := !sum + Allocation.samples a ~scale ~most:1000 x y
      done
    done;
    float_of_int !sum /. 5000.
  in
  Alcotest.(check (float 0.8)) "much noise" 40. (mean 10);
  Alcotest.(check (float 0.4)) "less noise" 20. (mean 120);
  Alcotest.(check (float 0.001))
    "the error that is left"
    ((4. *. 4. /. 40.) +. (4. /. 20.))
    (5. *. Allocation.error a ~law:1. ~scale ~most:1000)

let share = Draw.uniform 0. 1.

let suite =
  ( "allocations",
    [
      law "numbers are from the base to the most" scale one within;
      law "a greater scale takes no sample away" (Gen.pair scale scale) two
        monotone;
      law "what a pixel finds does not change its own number"
        Gen.(pair scale (pair nat squares))
        (fun (s, (i, x)) -> Printf.sprintf "%h, %h in pixel %d" s x i)
        own_left_out;
      Law.example "it changes its neighbours'" neighbours_told;
      law "numbers are the same again, in any order" scale one again;
      law "they add up to what was announced, about" scale one counted;
      law "from the base everywhere to the most where there is an error" scale
        one ends;
      law ~count:500 "a total is met" share one inverts_total;
      law ~count:500 "an error is met"
        (Gen.pair share (Draw.uniform 1. 1.5))
        two inverts_error;
      Law.example "samples go as the root of the error" shares;
    ] )

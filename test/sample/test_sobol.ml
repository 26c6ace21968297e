open Candor_sample
open Candor_oracle
open QCheck2

let key n = Key.v ~seed:n ~x:3 ~y:5 ~sample:0 ~bounce:0 Film
let cell n u = int_of_float (u *. float_of_int n)
let at n i = Sobol.pair ~key:(key n) i

(* {1 Nets} *)

let all_different cells =
  List.length (List.sort_uniq Int.compare cells) = List.length cells

(* Whether each box of every grid of 2^k boxes holds one of the points. *)
let is_net k points =
  let box a { Pattern.u; v } =
    (cell (1 lsl a) u lsl k) + cell (1 lsl (k - a)) v
  in
  List.for_all
    (fun a -> all_different (List.map (box a) points))
    (List.init (k + 1) Fun.id)

let block =
  let open Gen in
  let+ n = int and+ k = int_bound 9 and+ b = int_bound 0xffffff in
  (n, k, if k > 8 then b land 0x3fffff else b)

let show (n, k, b) = Printf.sprintf "key %d, block %d of 2^%d" n b k
let points f k b = List.init (1 lsl k) (fun i -> f ((b lsl k) + i))
let nets (n, k, b) = is_net k (points (at n) k b)

let nets_on_a_line (n, k, b) =
  all_different
    (List.map
       (fun i -> cell (1 lsl k) (Sobol.one ~key:(key n) i))
       (points Fun.id k b))

(* 2^16 points from the last. *)
let large_nets () =
  List.iter
    (fun (n, b) ->
      Alcotest.(check bool) (show (n, 16, b)) true (nets (n, 16, b)))
    [ (1, 0); (2, 0xffff) ]

let index = Gen.(oneof [ int_bound 4096; int_bound 0xffffffff ])
let show_index (n, i) = Printf.sprintf "key %d, point %d" n i

let in_square (n, i) =
  let { Pattern.u; v } = at n i in
  let fine x = 0. <= x && x < 1. && Float.is_integer (Float.ldexp x 53) in
  fine u && fine v && Float.equal u (Sobol.one ~key:(key n) i)

let low_bits (n, i) = at n i = at n (i + (1 lsl 32))

(* {1 Bit by bit} *)

(* The low 32 bits in reverse order, one after another. *)
let reverse x =
  let bit r i = if x land (1 lsl i) = 0 then r else r lor (1 lsl (31 - i)) in
  List.fold_left bit 0 (List.init 32 Fun.id)

(* N. Vegdahl's hash. *)
let scramble key x =
  let x = x lxor (x * 0x3d20adea) in
  let x = (x + key) * ((key lsr 16) lor 1) in
  let x = x lxor (x * 0x05526c56) in
  x lxor (x * 0x53a22864)

(* Bit i is the sum of the bits j for which C(j, i) is odd. *)
let pascal x =
  let odd i j = i land lnot j = 0 && x land (1 lsl j) <> 0 in
  let bit i =
    let terms = List.filter (odd i) (List.init 32 Fun.id) in
    (List.length terms land 1) lsl i
  in
  List.fold_left (fun y i -> y lor bit i) 0 (List.init 32 Fun.id)

let fraction x =
  Float.ldexp (float_of_int (reverse x)) (-32)
  +. Float.ldexp (float_of_int ((x lsr 32) land 0x1fffff)) (-53)

let plain key i =
  let derived k = (Key.derive key k :> int) in
  let i = reverse (scramble (derived 0) (reverse i)) in
  let digits k x = fraction (scramble (derived k) x) in
  { Pattern.u = digits 1 i; v = digits 2 (pascal i) }

let bit_by_bit (n, i) =
  let { Pattern.u; v } = plain (key n) i and found = at n i in
  Float.equal found.u u && Float.equal found.v v
  && Float.equal (Sobol.one ~key:(key n) i) u

(* {1 Over keys} *)

let keys = 1 lsl 17

let uniform () =
  let even name bins f =
    Chi_square.(even name (count bins keys (fun n -> f (key n))))
  in
  List.iter
    (fun i ->
      let name what = Printf.sprintf "%s of point %d" what i in
      let pair k = Sobol.pair ~key:k i in
      even (name "u") 4096 (fun k -> cell 4096 (pair k).u);
      even (name "v") 4096 (fun k -> cell 4096 (pair k).v);
      even (name "low bits of u") 4096 (fun k ->
          int_of_float (Float.ldexp (pair k).u 53) land 4095);
      even (name "low bits of v") 4096 (fun k ->
          int_of_float (Float.ldexp (pair k).v 53) land 4095);
      even (name "middle bits of u") 4096 (fun k ->
          int_of_float (Float.ldexp (pair k).u 26) land 4095);
      even (name "the place") 4096 (fun k ->
          let p = pair k in
          (64 * cell 64 p.u) + cell 64 p.v))
    [ 0; 1; 2; 17; 4095; 0xffffffff ]

(* Two numbers that scrambling takes apart at a digit are different in that digit
   and have nothing else to do with each other. For numbers of 0 and 1 that is
   the first digit, whatever the indices are shuffled to: a pair shares a half
   never; in which of the eighths of their halves they are is free. *)
let scrambled () =
  let even name f g =
    let bin n =
      (64 * cell 64 (Float.rem (2. *. f n) 1.))
      + cell 64 (Float.rem (2. *. g n) 1.)
    in
    Chi_square.(even name (count 4096 keys bin))
  in
  even "u of points 0 and 1" (fun n -> (at n 0).u) (fun n -> (at n 1).u);
  even "v of points 0 and 1" (fun n -> (at n 0).v) (fun n -> (at n 1).v);
  even "v of points 6 and 7" (fun n -> (at n 6).v) (fun n -> (at n 7).v)

(* {1 Between keys} *)

let covariance n f g =
  let sum h = List.fold_left (fun s i -> s +. h i) 0. (List.init n Fun.id) in
  let n = float_of_int n in
  let mean_f = sum f /. n and mean_g = sum g /. n in
  sum (fun i -> (f i -. mean_f) *. (g i -. mean_g)) *. 12. /. n

(* The points of two keys together are as even as independent ones. *)
let unrelated () =
  let points = 4096 in
  for n = 0 to 7 do
    let a = Key.derive (key n) 10 and b = Key.derive (key n) 11 in
    let even name f g =
      let bin i = (16 * cell 16 (f i)) + cell 16 (g i) in
      Chi_square.even
        (Printf.sprintf "%s, key %d" name n)
        (Chi_square.count 256 points bin);
      let r = covariance points f g in
      if Float.abs r > 0.08 then
        Alcotest.failf "%s, key %d: correlation %g" name n r
    in
    let u k i = (Sobol.pair ~key:k i).u and v k i = (Sobol.pair ~key:k i).v in
    even "u and u" (u a) (u b);
    even "v and v" (v a) (v b);
    even "u and v" (u a) (v b)
  done

(* The same for one index over many keys: padding is unbiased. *)
let padded () =
  let bin n =
    let k = key n in
    let u i = (Sobol.pair ~key:(Key.derive k i) 5).u in
    (64 * cell 64 (u 0)) + cell 64 (u 1)
  in
  Chi_square.(even "point 5 of two keys" (count 4096 keys bin))

(* {1 Integrals} *)

let rms_error ~points f exact place =
  let repeats = 64 in
  let error n =
    let sum = ref 0. in
    for i = 0 to points - 1 do
      let { Pattern.u; v } = place n i in
      sum := !sum +. f u v
    done;
    (!sum /. float_of_int points) -. exact
  in
  let squares =
    List.fold_left
      (fun s n -> s +. (error n ** 2.))
      0. (List.init repeats Fun.id)
  in
  sqrt (squares /. float_of_int repeats)

let independent n i =
  let k = Key.derive (key n) i in
  { Pattern.u = Key.float (Key.derive k 0); v = Key.float (Key.derive k 1) }

let quarter_disk u v = if (u *. u) +. (v *. v) < 1. then 1. else 0.
let smooth u v = exp (u +. v)
let e = exp 1. -. 1.

(* How often less the error is than that of as many independent places. *)
let converges () =
  List.iter
    (fun (name, f, exact, least) ->
      List.iter
        (fun (points, least) ->
          let sobol = rms_error ~points f exact at in
          let other = rms_error ~points f exact independent in
          Printf.printf "%s, %d points: %.2e, independent %.2e, ratio %.1f\n"
            name points sobol other (other /. sobol);
          if other < least *. sobol then
            Alcotest.failf "%s, %d points: only %.1f times better" name points
              (other /. sobol))
        least)
    [
      ("exp (u + v)", smooth, e *. e, [ (16, 3.); (256, 20.); (1024, 40.) ]);
      ( "a quarter disk",
        quarter_disk,
        Float.pi /. 4.,
        [ (16, 1.5); (256, 3.); (1024, 4.) ] );
    ]

let law name gen show f = Law.law ~count:1000 ~print:show name gen f

let suite =
  ( "sobol points",
    [
      law "each aligned block of 2^k points has one in each box" block show nets;
      law "each aligned block of 2^k numbers has one in each interval" block
        show nets_on_a_line;
      Law.example "so do blocks of 65,536, the first and the last" large_nets;
      law "G25: points are in [0;1[, multiples of 2^-53, and one is u of pair"
        Gen.(pair int index)
        show_index in_square;
      law "of an index the low 32 bits count"
        Gen.(pair int index)
        show_index low_bits;
      law "points are what loops over bits make them"
        Gen.(pair int index)
        show_index bit_by_bit;
      Law.example "every point by itself is uniform over keys" uniform;
      Law.example "two points of one key are as far apart as scrambling says"
        scrambled;
      Law.example "points of two keys are unrelated" unrelated;
      Law.example "one index of two keys is uniform in the square" padded;
      Law.example "means converge faster than with independent numbers"
        converges;
    ] )

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
  costs : float array;
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
  and+ costs =
    let size = pure (width * height) in
    oneof
      [
        array_size size (Draw.uniform 1. 50.);
        pure (Array.make (width * height) 1.);
      ]
  in
  { width; height; base; most; squares; costs }

let show c =
  Printf.sprintf "%dx%d from %d to %d: %s" c.width c.height c.base c.most
    (String.concat " "
       (List.map (Printf.sprintf "%h") (Array.to_list c.squares)))

let window x1 y1 = { Window.x0 = 0; y0 = 0; x1; y1 }

let make ?(squares = fun c i -> c.squares.(i)) ?(cost = fun c i -> c.costs.(i))
    c =
  let at f x y = f c ((y * c.width) + x) in
  Allocation.make (window c.width c.height) ~base:c.base ~cost:(at cost)
    (at squares)

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
  && Allocation.mean a All ~scale:low ~most:c.most
     <= Allocation.mean a All ~scale:high ~most:c.most *. (1. +. 0x1p-40)
  && Allocation.error a ~law:1. ~scale:high ~most:c.most
     <= Allocation.error a ~law:1. ~scale:low ~most:c.most *. (1. +. 0x1p-40)

let advises part (x, y) =
  let first, second = Part.advisers in
  List.exists
    (fun (dx, dy) -> Part.of_pixel (x - dx) (y - dy) = part)
    (first @ second)

(* Whatever its part and those that do not advise it find, the number of a pixel
   is the same: this is why its mean is right on average. *)
let advisers_alone (c, (scale, (part, other))) =
  let changed f c i =
    if advises part (i mod c.width, i / c.width) then f c i else other
  in
  let numbers a =
    ( Allocation.for_mean a (Part part) ~most:c.most (2. *. float_of_int c.base),
      List.filter_map
        (fun (x, y) ->
          if Part.of_pixel x y = part then
            Some (Allocation.samples a ~scale ~most:c.most x y)
          else None)
        (places c) )
  in
  let squares c i = c.squares.(i) and cost c i = c.costs.(i) in
  numbers (make c)
  = numbers (make ~squares:(changed squares) ~cost:(changed cost) c)

(* What is next to much noise is taken for noise. *)
let neighbours_told () =
  let noisy x y =
    if abs (x - 20) <= 1 then 100. else 1. +. float_of_int (y mod 2)
  in
  let a = Allocation.make (window 40 40) ~base:4 ~cost:(fun _ _ -> 1.) noisy in
  let n x y = Allocation.samples a ~scale:100. ~most:1_000_000 x y in
  for y = 0 to 39 do
    Alcotest.(check bool) "much noise" true (n 20 y >= 512);
    Alcotest.(check bool) "next to it" true (n 22 y > n 30 y);
    Alcotest.(check bool) "little noise" true (n 5 y <= 256)
  done

(* Noise that advisers do not agree on is chance: all pixels are alike. *)
let rare x y =
  let key = Candor_sample.Key.v ~seed:1 ~x ~y ~sample:0 ~bounce:0 Film in
  if Candor_sample.Key.float key < 0.02 then 1000. else 1.

let chance () =
  let check ~cost noise (low, high) =
    let a = Allocation.make (window 60 60) ~base:4 ~cost noise in
    let scale = Allocation.for_mean a All ~most:100_000 40. in
    for y = 0 to 59 do
      for x = 0 to 59 do
        let n = Allocation.samples a ~scale ~most:100_000 x y in
        if not (low <= n && n <= high) then Alcotest.failf "%d samples" n
      done
    done
  in
  let alike _ _ = 1. in
  check ~cost:alike rare (16, 128);
  (* That costs differ does not make advisers agree. *)
  check ~cost:(fun x _ -> if x < 30 then 1. else 16.) rare (8, 256);
  (* Who knows nothing does not agree with who knows something. *)
  let once x y = if x = 30 && y = 30 then 1000. else 0. in
  check ~cost:alike once (0, 128)

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
let pixels c = float_of_int (c.width * c.height)
let total c a ~scale = pixels c *. Allocation.mean a All ~scale ~most:c.most

(* Classes are an eighth of an octave of roots wide and count with their mean, so
   only one that the base or the most cuts through is off: 2.3 % are enough.
   Between powers of two a coin decides, of which each pixel has one:
   what that adds has a deviation of half the number or less. *)
let counted (c, scale) =
  let a = make c in
  let total = total c a ~scale in
  let counts = counts c a scale in
  let deviation = 0.5 *. sqrt (sum (List.map (fun n -> n *. n) counts)) in
  Float.abs (sum counts -. total) <= (0.023 *. total) +. (5. *. deviation)
  || Law.fail "%g, but %g were announced" (sum counts) total

let ends (c, _) =
  let a = make c in
  Allocation.mean a All ~scale:0. ~most:c.most = float_of_int c.base
  &&
  let greatest = Allocation.for_mean a All ~most:c.most infinity in
  let none = Allocation.error a ~law:1. ~scale:0. ~most:c.most = 0. in
  (Allocation.error a ~law:1. ~scale:0. ~most:c.most = if none then 0. else 1.)
  && greatest = Allocation.for_error a ~law:1. ~most:c.most (-1.)
  && Float.is_finite greatest
  && List.for_all
       (fun (x, y) ->
         let n = Allocation.samples a ~scale:greatest ~most:c.most x y in
         n = c.most || n = c.base)
       (places c)

let inverts_mean (c, (part, share)) =
  let a = make c and most = c.most in
  let mean scale = Allocation.mean a part ~scale ~most in
  let low = mean 0. in
  let high = mean (Allocation.for_mean a part ~most infinity) in
  let n = low +. (share *. (high -. low)) in
  let found = mean (Allocation.for_mean a part ~most n) in
  Float.abs (found -. n) <= 1e-6 *. n
  || Law.fail "%g instead of %g, of %g to %g" found n low high

(* The whole is its parts. *)
let of_parts (c, scale) =
  let a = make c and most = c.most in
  let of_part part =
    let is (x, y) = Part.of_pixel x y = part in
    let pixels = List.length (List.filter is (places c)) in
    float_of_int pixels *. Allocation.mean a (Part part) ~scale ~most
  in
  let sum = sum (List.map of_part Part.all) in
  let total = total c a ~scale in
  (* Pixels of a class are counted with their mean, which differs. *)
  Float.abs (sum -. total) <= 0.05 *. total
  || Law.fail "%g instead of %g" sum total

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
    Allocation.make (window 200 100) ~base:4
      ~cost:(fun _ _ -> 1.)
      (fun x _ -> if x < 100 then 4. else 1.)
  in
  let scale = Allocation.for_mean a All ~most:1000 30. in
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

let costly () =
  let cost x _ = if x < 100 then 4. else 1. in
  let a = Allocation.make (window 200 100) ~base:4 ~cost (fun _ _ -> 1.) in
  let scale = Allocation.for_mean a All ~most:1000 30. in
  let n x = Allocation.samples a ~scale ~most:1000 x in
  let mean x0 =
    let sum = ref 0 in
    for y = 0 to 99 do
      for x = x0 to x0 + 49 do
        sum := !sum + n x y
      done
    done;
    float_of_int !sum /. 5000.
  in
  Alcotest.(check (float 0.4)) "dear" 20. (mean 10);
  Alcotest.(check (float 0.8)) "cheap" 40. (mean 120)

(* What samples beyond the base cost, by those that are wanted. *)
let worked () =
  let cost x _ = if x < 100 then 4. else 1. in
  let noise x _ = if x < 100 then 4. else 1. in
  let a = Allocation.make (window 200 100) ~base:4 ~cost noise in
  (* √(4/4) and √(1/1) are equal shares. *)
  Alcotest.(check (float 0.05)) "even shares" 2.5 (Allocation.work a);
  let a = Allocation.make (window 200 100) ~base:4 ~cost (fun _ _ -> 1.) in
  (* Twice as many where they are cheap. *)
  Alcotest.(check (float 0.05)) "mostly cheap" 2. (Allocation.work a)

let share = Draw.uniform 0. 1.
let index = Gen.int_bound (Part.count - 1)

let part =
  Gen.oneof
    [ Gen.pure Allocation.All; Gen.map (fun i -> Allocation.Part i) index ]

let of_part = function
  | Allocation.All -> "all"
  | Part i -> Printf.sprintf "part %d" i

(* Nobody has less, and what they leave together is no more. *)
let broader (c, scale) =
  let a = make c and most = c.most in
  let b = Allocation.with_base a (2 * c.base) in
  let error a = Allocation.error a ~law:1. ~scale ~most in
  2 * c.base > most
  || Allocation.base b = 2 * c.base
     && List.for_all
          (fun (x, y) ->
            let had = Allocation.samples a ~scale ~most x y
            and has = Allocation.samples b ~scale ~most x y in
            has >= Int.max had (2 * c.base))
          (places c)
     && Allocation.mean b All ~scale ~most
        >= Allocation.mean a All ~scale ~most *. (1. -. 1e-9)
     && 0.5 *. error b <= error a *. (1. +. 1e-9)

let suite =
  ( "allocations",
    [
      law "numbers are from the base to the most" scale one within;
      law "a greater scale takes no sample away" (Gen.pair scale scale) two
        monotone;
      law "what pixels have depends on the advisers of their part alone"
        Gen.(pair scale (pair index squares))
        (fun (s, (i, x)) ->
          Printf.sprintf "%h, %h but for advisers of %d" s x i)
        advisers_alone;
      Law.example "neighbours ask for more" neighbours_told;
      Law.example "what advisers do not agree on is chance" chance;
      Law.example "what costs four times as much has half as many" costly;
      Law.example "the work of a sample is that where it goes" worked;
      law "numbers are the same again, in any order" scale one again;
      law "they add up to what was announced, about" scale one counted;
      law "from the base everywhere to the most where there is an error" scale
        one ends;
      law ~count:500 "a mean is met" (Gen.pair part share)
        (fun (p, x) -> Printf.sprintf "%h of %s" x (of_part p))
        inverts_mean;
      law "all pixels are those of the parts" scale one of_parts;
      law ~count:500 "an error is met"
        (Gen.pair share (Draw.uniform 1. 1.5))
        two inverts_error;
      law "a larger base takes no sample away, and leaves no more error" scale
        one broader;
      Law.example "samples go as the root of the error" shares;
    ] )

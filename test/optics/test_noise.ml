open Candor_space
open Candor_optics
open Candor_sample
open Candor_oracle
open QCheck2

(* The [k]-th random number of case [i]. *)
let uniform i k =
  let key = Key.v ~seed:11 ~x:0 ~y:0 ~sample:i ~bounce:0 Film in
  Key.float (Key.derive key k)

let at ?(layer = 0) x y z = Noise.gradient ~layer (Point.v x y z)
let print = Draw.show_point

let wide =
  Draw.point
    (Gen.oneof
       [
         Draw.uniform (-50.) 50.;
         Draw.any_coordinate;
         Draw.signed (Draw.power (-1074) 1023);
         Draw.pick [ infinity; neg_infinity; nan; max_float; -.max_float ];
       ])

let bounded p =
  let n = Noise.gradient ~layer:0 p in
  let m = Noise.mix ~octaves:5 p in
  -1. <= n && n <= 1. && 0. <= m && m <= 1.

(* The largest value that any choice of gradients gives at (x, y, z): at each
   corner the best gradient adds the two largest of the offsets. *)
let best x y z =
  let fade t = t *. t *. t *. ((t *. ((t *. 6.) -. 15.)) +. 10.) in
  let corner i =
    let side t bit =
      if (i lsr bit) land 1 = 0 then (1. -. fade t, t) else (fade t, 1. -. t)
    in
    let wx, x = side x 0 and wy, y = side y 1 and wz, z = side z 2 in
    wx *. wy *. wz *. (x +. y +. z -. Float.min x (Float.min y z))
  in
  List.fold_left (fun sum i -> sum +. corner i) 0. [ 0; 1; 2; 3; 4; 5; 6; 7 ]

let extreme () =
  let n = 64 in
  let greatest = ref 0. in
  let part i = float_of_int i /. float_of_int n in
  for i = 0 to n do
    for j = 0 to n do
      for k = 0 to n do
        greatest := Float.max !greatest (best (part i) (part j) (part k))
      done
    done
  done;
  if !greatest < 1.03 || !greatest > 1.04 then
    Alcotest.failf "the greatest value is %g" !greatest

let lattice =
  let whole =
    Gen.oneof
      [ Draw.small 99; Draw.signed (Draw.power 0 400); Draw.pick [ -0. ] ]
  in
  Draw.point whole

(* Second differences vanish on the lattice only for a blend with no curvature
   there; elsewhere they are bounded. *)
let smooth (p : Point.t) =
  let h = 0x1p-12 in
  let n x = at x p.y p.z in
  let x = Float.round p.x in
  let curvature = (n (x +. h) -. (2. *. n x) +. n (x -. h)) /. (h *. h) in
  let before = n (x -. h) -. (2. *. n (x -. (2. *. h))) +. n (x -. (3. *. h))
  and after = n (x +. (3. *. h)) -. (2. *. n (x +. (2. *. h))) +. n (x +. h) in
  let jump = (after -. before) /. (h *. h) in
  Float.abs jump < 0.1 && Float.abs curvature < 10.

let near (p, q) =
  let a = Noise.gradient ~layer:0 p and b = Noise.gradient ~layer:0 q in
  Float.abs (a -. b) <= 6. *. Vec.norm (Point.sub p q)

let neighbours =
  let open Gen in
  let* p = Draw.point (Draw.snapped (Draw.uniform (-20.) 20.)) in
  let+ d = Draw.vec (Draw.signed (Draw.wide (-12.) 0.)) in
  (p, Point.add p d)

(* Values of the formula's sum over corners, computed elsewhere. *)
let stored () =
  let check name expected found =
    Alcotest.(check (float 1e-15)) name expected found
  in
  let p = Point.v 0.3 (-1.7) 2.6 in
  check "noise" (-0.17789865897758406) (Noise.gradient ~layer:0 p);
  check "layer 3" (-0.04293063778103994) (Noise.gradient ~layer:3 p);
  check "four octaves" (-0.13203453737822715) (Noise.fractal ~octaves:4 p);
  check "mixed" 0.43398273131088644 (Noise.mix ~octaves:4 p)

let octaves p =
  let octave i = Float.ldexp (Noise.gradient ~layer:i (Point.ldexp i p)) (-i) in
  let same octaves =
    let sum f = List.fold_left ( +. ) 0. (List.init octaves f) in
    let expected = sum octave /. sum (fun i -> Float.ldexp 1. (-i)) in
    Float.abs (Noise.fractal ~octaves p -. expected) <= 1e-15
  in
  List.for_all same [ 1; 2; 3; 8 ]
  && Float.equal (Noise.fractal ~octaves:0 p) (Noise.fractal ~octaves:1 p)
  && Float.equal
       (Noise.fractal ~octaves:53 p)
       (Noise.fractal ~octaves:max_int p)

let repeats (p : Point.t) =
  let far = Point.v (p.x +. 0x1p32) (p.y -. 0x1p33) (p.z +. 0x1p34) in
  Float.equal (Noise.gradient ~layer:0 p) (Noise.gradient ~layer:0 far)

(* Points of one eighth, so that adding the period is exact. *)
let eighths =
  Draw.point (Gen.map (fun i -> float_of_int i /. 8.) (Gen.int_bound 999))

let cells = 40_000

(* The mean and the mean square of [f] at random points of as many cells. *)
let moments f =
  let sum = ref 0. and squares = ref 0. in
  for i = 0 to cells - 1 do
    let u k = uniform i k in
    let x = f (Point.v (1000. *. u 0) (1000. *. u 1) (1000. *. u 2)) in
    sum := !sum +. x;
    squares := !squares +. (x *. x)
  done;
  (!sum /. float_of_int cells, !squares /. float_of_int cells)

let even () =
  let mean, _ = moments (Noise.mix ~octaves:4) in
  Alcotest.(check (float 0.005)) "the mean of mix" 0.5 mean;
  let mean, square = moments (Noise.gradient ~layer:0) in
  Alcotest.(check (float 0.01)) "the mean" 0. mean;
  if square < 0.04 || square > 0.12 then
    Alcotest.failf "the mean square is %g" square;
  let _, both =
    moments (fun p -> Noise.gradient ~layer:0 p +. Noise.gradient ~layer:1 p)
  in
  Alcotest.(check (float 0.01)) "layers are independent" (2. *. square) both

(* Gradients seen at points of the lattice: the slope along each axis. *)
let gradients () =
  let h = 0x1p-30 in
  let counts = Hashtbl.create 12 in
  for i = 0 to 15_999 do
    let x = float_of_int (i mod 40)
    and y = float_of_int (i / 40 mod 20)
    and z = float_of_int (i / 800) in
    let slope dx dy dz =
      let n = at (x +. dx) (y +. dy) (z +. dz) /. (0.9375 *. h) in
      int_of_float (Float.round n)
    in
    let g = (slope h 0. 0., slope 0. h 0., slope 0. 0. h) in
    Hashtbl.replace counts g
      (1 + Option.value ~default:0 (Hashtbl.find_opt counts g))
  done;
  Alcotest.(check int) "twelve gradients" 12 (Hashtbl.length counts);
  Hashtbl.iter
    (fun (x, y, z) n ->
      if abs x + abs y + abs z <> 2 then Alcotest.failf "(%d %d %d)" x y z;
      let once = abs (n - 1000) < 200 and twice = abs (n - 2000) < 280 in
      if not (once || twice) then Alcotest.failf "one gradient %d times" n)
    counts

let suite =
  ( "noise",
    [
      Law.law ~print "noise is in [-1;1] and mixes in [0;1], anywhere" wide
        bounded;
      Law.example "noise without its factor reaches 1.0364" extreme;
      Law.law ~print "noise is 0 on the lattice" lattice (fun p ->
          Noise.gradient ~layer:2 p = 0.);
      Law.law ~print "curvature does not jump between cells"
        (Draw.point (Draw.uniform (-20.) 20.))
        smooth;
      Law.law
        ~print:(fun (p, q) -> print p ^ " " ^ print q)
        "noise changes by at most 6 per unit" neighbours near;
      Law.example "noise is the same for ever" stored;
      Law.law ~count:500 ~print "octaves halve in height and in width"
        (Draw.point (Draw.uniform (-20.) 20.))
        octaves;
      Law.law ~print "noise repeats after 2^32 units" eighths repeats;
      Law.example "noise is as often above as below, and layers differ" even;
      Law.example "gradients go to the edges of a cube, evenly" gradients;
    ] )

open Candor_sample
open Candor_oracle
open QCheck2

let floor_of n u = int_of_float (Float.floor (u *. float_of_int n))

let positions ?(seed = 0) ~spp x y =
  Array.init spp (Pattern.position (Pattern.make ~seed ~spp) ~x ~y)

let gen =
  let open Gen in
  let+ spp = oneof [ int_range 1 40; Draw.pick [ 64; 100; 101; 256; 1000 ] ]
  and+ x = int_bound 5000
  and+ y = int_bound 5000
  and+ seed = int in
  (spp, x, y, seed)

let show (spp, x, y, seed) =
  Printf.sprintf "%d spp, pixel %d %d, seed %d" spp x y seed

let law name f = Law.law ~count:1000 ~print:show name gen f
let all (spp, x, y, seed) = positions ~seed ~spp x y
let once n cells = List.sort Int.compare cells = List.init n Fun.id

let in_square case =
  Array.for_all
    (fun { Pattern.u; v } -> 0. <= u && u < 1. && 0. <= v && v < 1.)
    (all case)

let rows ((spp, _, _, _) as case) =
  once spp
    (List.map (fun p -> floor_of spp p.Pattern.v) (Array.to_list (all case)))

let columns_of spp = int_of_float (sqrt (float_of_int spp))

(* Of each run of √spp rows, every column holds one; of the last run, which may
   be shorter, no column holds two. *)
let cells ((spp, _, _, _) as case) =
  let columns = columns_of spp in
  let place { Pattern.u; v } = (floor_of spp v / columns, floor_of columns u) in
  let places = List.map place (Array.to_list (all case)) in
  List.length (List.sort_uniq compare places) = spp

(* As many steps across as there are cells in the grid: the samples share none. *)
let steps_across ((spp, _, _, _) as case) =
  let columns = columns_of spp in
  let rows = (spp + columns - 1) / columns in
  let steps =
    List.map
      (fun p -> floor_of (columns * rows) p.Pattern.u)
      (Array.to_list (all case))
  in
  List.length (List.sort_uniq Int.compare steps) = spp

let any_order ((spp, x, y, seed) as case) =
  let forwards = all case in
  let pattern = Pattern.make ~seed ~spp in
  let backwards =
    List.init spp (fun i -> Pattern.position pattern ~x ~y (spp - 1 - i))
  in
  List.rev backwards = Array.to_list forwards

(* Seeds, found by running the hash backwards, with which the first sample of the
   first pixel is as far as it gets in its cell (0 or 1 - 2^-53), across or in its
   row. *)
let extremes =
  [
    4506709122190709474;
    2046403769988206410;
    -3995807389729937349;
    3937777261843076881;
    3692768939964956438;
    1077809018168410219;
    4002374431446509928;
    -709021044362011754;
  ]

(* The same for a sample in the last of a thousand rows, where the least number
   above 999 + (1 - 2^-53) is 1000. *)
let extremes_of_last_row =
  [
    (1846189562279299240, 0);
    (-4584348220055875259, 2);
    (4292809776189232567, 1);
    (2295146701218088682, 1);
  ]

let at_the_edge () =
  let within { Pattern.u; v } =
    let in_tent u = -1. <= Pattern.tent u && Pattern.tent u < 1. in
    0. <= u && u < 1. && 0. <= v && v < 1. && in_tent u && in_tent v
  in
  let check seed = Alcotest.(check bool) (Printf.sprintf "seed %d" seed) true in
  List.iter
    (fun seed -> check seed (Array.for_all within (positions ~seed ~spp:4 0 0)))
    extremes;
  List.iter
    (fun (seed, sample) ->
      let at = (positions ~seed ~spp:1000 0 0).(sample) in
      check seed (within at && floor_of 1000 at.v = 999))
    extremes_of_last_row

let uniform () =
  let pixels = 1 lsl 13 and bins = 48 in
  List.iter
    (fun spp ->
      for s = 0 to spp - 1 do
        let pattern = Pattern.make ~seed:5 ~spp in
        let position i =
          Pattern.position pattern ~x:(i land 127) ~y:(i lsr 7) s
        in
        let even what n bin =
          Chi_square.even
            (Printf.sprintf "%s of sample %d of %d" what s spp)
            (Chi_square.count n pixels (fun i -> bin (position i)))
        in
        even "u" bins (fun p -> floor_of bins p.u);
        even "v" bins (fun p -> floor_of bins p.v);
        even "the place" 64 (fun p -> (8 * floor_of 8 p.u) + floor_of 8 p.v)
      done)
    [ 1; 2; 3; 4; 5; 7; 9; 16; 17 ]

let pixels_differ () =
  let pattern = Pattern.make ~seed:0 ~spp:16 in
  let pixels = 1 lsl 16 in
  let bin i =
    let at x = (Pattern.position pattern ~x ~y:(i lsr 8) 3).u in
    let x = i land 255 in
    (16 * floor_of 16 (at x)) + floor_of 16 (at (x + 1))
  in
  Chi_square.(even "u of one pixel and the next" (count 256 pixels bin))

(* Within its stratum a sample is anywhere, whatever the others do. *)
let jitters () =
  let spp = 4 and pixels = 1 lsl 16 in
  let pattern = Pattern.make ~seed:0 ~spp in
  let within x = floor_of 16 (Float.rem (x *. float_of_int spp) 1.) in
  let even name f g =
    let bin i =
      let at = Pattern.position pattern ~x:(i land 255) ~y:(i lsr 8) in
      (16 * f at) + g at
    in
    Chi_square.(even name (count 256 pixels bin))
  in
  let u s at = within (at s).Pattern.u and v s at = within (at s).Pattern.v in
  even "u of two samples" (u 0) (u 1);
  even "v of two samples" (v 1) (v 3);
  even "u and v of one" (u 2) (v 2)

(* The distribution function of the tent is what [tent] is the inverse of. *)
let tent_area x =
  if x < 0. then ((1. +. x) ** 2.) /. 2. else 1. -. (((1. -. x) ** 2.) /. 2.)

let unit = Gen.oneof [ Draw.uniform 0. 1.; Draw.wide (-18.) (-1.) ]
let show_u = Printf.sprintf "%h"
let unit_law name f = Law.law ~print:show_u name unit (fun u -> u >= 1. || f u)

let in_tent u =
  let x = Pattern.tent u in
  -1. <= x && x < 1.

let inverts u = Float.abs (tent_area (Pattern.tent u) -. u) <= 0x1p-52

(* 1 - u is exact from 1/2 on. *)
let odd u = u < 0.5 || Pattern.tent (1. -. u) = -.Pattern.tent u

let tent_points () =
  let check x u = Alcotest.(check (float 0.)) (show_u u) x (Pattern.tent u) in
  check (-1.) 0.;
  check (1. -. 0x1p-26) (Float.pred 1.);
  check (-0.5) 0.125;
  check 0. 0.5;
  check 0.5 0.875

let tent_moments () =
  let n = 1 lsl 16 in
  let mean f =
    let sum = ref 0. in
    for i = 0 to n - 1 do
      sum :=
        !sum +. f (Pattern.tent ((float_of_int i +. 0.5) /. float_of_int n))
    done;
    !sum /. float_of_int n
  in
  Alcotest.(check (float 1e-12)) "its mean" 0. (mean Fun.id);
  Alcotest.(check (float 1e-6))
    "its variance" (1. /. 6.)
    (mean (fun x -> x *. x))

let tent_rises =
  Law.law
    ~print:(fun (u, v) -> show_u u ^ " " ^ show_u v)
    "tent is monotone" (Gen.pair unit unit)
    (fun (u, v) -> u > v || Pattern.tent u <= Pattern.tent v)

let suite =
  ( "patterns",
    [
      law "G25: samples are in the unit square" in_square;
      Law.example "G25: nor do they leave it where keys give 0 or 1 - 2^-53"
        at_the_edge;
      law "each of the spp rows holds exactly one sample" rows;
      law "each cell of the grid holds one sample" cells;
      law "samples are stratified across as well" steps_across;
      law "positions do not depend on the order of asking" any_order;
      Law.example "every sample by itself is uniform over pixels" uniform;
      Law.example "neighbouring pixels have independent patterns" pixels_differ;
      Law.example "samples are anywhere in their strata, independently" jitters;
      unit_law "G25: tent is within [-1;1[" in_tent;
      unit_law "tent is the inverse of the area under 1 - |x|" inverts;
      unit_law "tent is odd about a half, to the bit" odd;
      tent_rises;
      Law.example "tent takes quarters where it should" tent_points;
      Law.example "tent has mean 0 and variance 1/6" tent_moments;
    ] )

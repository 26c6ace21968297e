open Candor_sample
open Candor_oracle
open QCheck2

let at ?(seed = 0) ?(sample = 0) ?(bounce = 0) x y =
  Key.v ~seed ~x ~y ~sample ~bounce Film

let number ?seed ?sample ?bounce x y = Key.float (at ?seed ?sample ?bounce x y)
let bin n u = int_of_float (u *. float_of_int n)

(* The pixels of a picture of 1024 x 1024. *)
let pixels = 1 lsl 20
let over_pixels f i = f (i land 1023) (i lsr 10)

let uniform () =
  let bins = 1 lsl 16 in
  let high f = over_pixels (fun x y -> bin bins (f x y)) in
  let even name f = Chi_square.(even name (count bins pixels (high f))) in
  even "over pixels" (fun x y -> number x y);
  even "over samples and seeds" (fun x y -> number ~sample:x ~seed:y 3 5);
  even "over bounces" (fun x y -> number ~bounce:x 17 y);
  even "over derived keys" (fun x y -> Key.float (Key.derive (at 1 y) x));
  let low x y = int_of_float (Float.ldexp (number x y) 53) land (bins - 1) in
  Chi_square.(even "low bits" (count bins pixels (over_pixels low)))

let independent () =
  let side = 256 in
  let pair f g x y = (bin side (f x y) * side) + bin side (g x y) in
  let even name f g =
    Chi_square.(even name (count (side * side) pixels (over_pixels (pair f g))))
  in
  let here x y = number x y in
  even "the next pixel" here (fun x y -> number (x + 1) y);
  even "the next row" here (fun x y -> number x (y + 1));
  even "the pixel across the diagonal" here (fun x y -> number y (x + 2000));
  even "the next sample" here (fun x y -> number ~sample:1 x y);
  even "the next bounce" here (fun x y -> number ~bounce:1 x y);
  even "the next seed" here (fun x y -> number ~seed:1 x y);
  even "two derived keys"
    (fun x y -> Key.float (Key.derive (at x y) 0))
    (fun x y -> Key.float (Key.derive (at x y) 1))

let distinct () =
  let seen = Hashtbl.create 65536 in
  for x = -64 to 63 do
    for y = -64 to 63 do
      for sample = 0 to 3 do
        let k = (at ~sample x y :> int) in
        if Hashtbl.mem seen k then Alcotest.failf "pixel %d %d: a key twice" x y;
        Hashtbl.add seen k ()
      done
    done
  done

let position = Gen.(triple (int_range (-1000) 100000) (int_bound 100000) int)
let show (x, y, seed) = Printf.sprintf "%d %d seed %d" x y seed

let in_range (x, y, seed) =
  let u = number ~seed x y in
  0. <= u && u < 1. && Float.is_integer (Float.ldexp u 53)

(* Seeds found by running the hash backwards. *)
let extremes () =
  let check name = Alcotest.(check (float 0.)) name in
  check "the least" 0. (number ~seed:3201355884347206473 0 0);
  check "the greatest" (Float.pred 1.) (number ~seed:3297201218104050994 0 0)

let repeats (x, y, seed) =
  let first = number ~seed x y in
  ignore (number ~seed (x + 1) y : float);
  Float.equal first (number ~seed x y)

let is_permutation k length =
  let hit = Array.make length false in
  for i = 0 to length - 1 do
    hit.(Key.permute k ~length i) <- true
  done;
  Array.for_all Fun.id hit

let permutations () =
  let lengths =
    List.init 300 succ
    @ [ 1023; 1024; 1025; 4095; 65536; 65537; 100_003; 262_144 ]
  in
  List.iter
    (fun length ->
      let keys = if length > 300 then 2 else 20 in
      for i = 0 to keys - 1 do
        if not (is_permutation (at i length) length) then
          Alcotest.failf "length %d, key %d" length i
      done)
    lengths

(* Every place goes everywhere equally often. *)
let even_permutations () =
  List.iter
    (fun length ->
      for i = 0 to length - 1 do
        let goes x = Key.permute (at x 9) ~length i in
        Chi_square.(
          even
            (Printf.sprintf "length %d, from %d" length i)
            (count length 8192 goes))
      done)
    [ 2; 3; 4; 5; 6; 7; 8; 9; 12; 16; 17; 25; 31; 64; 100 ]

let many_permutations () =
  List.iter
    (fun (length, all) ->
      let seen = Hashtbl.create all in
      for x = 0 to 4095 do
        Hashtbl.replace seen
          (List.init length (Key.permute (at x 1) ~length))
          ()
      done;
      Alcotest.(check int)
        (Printf.sprintf "of length %d" length)
        all (Hashtbl.length seen))
    [ (1, 1); (2, 2); (3, 6) ]

let suite =
  ( "keys",
    [
      Law.example "numbers are uniform in 65,536 bins, high bits and low"
        uniform;
      Law.example "neighbouring keys give independent numbers" independent;
      Law.example "different uses have different keys" distinct;
      Law.example "G25: the numbers 0 and 1 - 2^-53 turn up, 1 does not"
        extremes;
      Law.law ~print:show "G25: a number is in [0;1[, a multiple of 2^-53"
        position in_range;
      Law.law ~print:show "a number does not depend on what is asked before"
        position repeats;
      Law.example
        "permute is a permutation for lengths 1 to 300 and some large ones"
        permutations;
      Law.example "permute takes every place everywhere equally often"
        even_permutations;
      Law.example "every permutation of up to 3 things turns up"
        many_permutations;
    ] )

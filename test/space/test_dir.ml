open Candor_space
open Candor_oracle
open Places

(* |u·u − 1| ≤ 2^-50 and u is along a within 2^-51 of its components. *)
let unit a =
  match Dir.of_vec a with
  | None -> Vec.equal a Vec.zero
  | Some u ->
      let u = (u :> Vec.t) in
      let s = squares u in
      let off = Exact.(cross (vec u) (vec a)) in
      Q.leq (Q.abs (Q.sub s Q.one)) (Exact.power (-50))
      && Q.leq (Exact.largest off) Exact.(power (-51) * size (vec a))
      && Q.sign Exact.(dot (vec u) (vec a)) > 0

let scaled (a, k) =
  let by = Float.ldexp 1. k in
  Dir.of_vec a = Dir.of_vec (Vec.scale by a)

(* What [of_vec] and [norm] do where squares may leave the range: the length is
   taken near 1. *)
let by_way_of_one a =
  let e = Vec.exponent a in
  let near = Vec.ldexp (-e) a in
  let n = sqrt (Vec.dot near near) in
  (Vec.v (near.x /. n) (near.y /. n) (near.z /. n), Float.ldexp n e)

let as_plain_squares (a, k) =
  let a = Vec.ldexp k a in
  let largest = Vec.largest a in
  let plain = Vec.has_plain_square (Vec.dot a a) in
  (not plain)
  || largest > 0x1p-400 && largest < 0x1p400
     &&
     let d, n = by_way_of_one a in
     Float.equal (Vec.norm a) n
     && (Dir.of_vec_or Dir.z a :> Vec.t) = d
     && Dir.of_vec a = Some (Dir.of_vec_or Dir.z a)

let none () =
  List.iter
    (fun a ->
      Alcotest.(check bool) (show a) true (Dir.of_vec a = None);
      Alcotest.(check bool) "or" true (Dir.of_vec_or Dir.y a = Dir.y))
    [
      Vec.zero;
      Vec.v (-0.) 0. (-0.);
      Vec.v nan 0. 1.;
      Vec.v infinity 0. 1.;
      Vec.v 1. neg_infinity 1.;
    ]

let extremes () =
  List.iter
    (fun a ->
      match Dir.of_vec a with
      | Some u -> Alcotest.(check bool) (show a) true (u = Dir.x)
      | None -> Alcotest.fail (show a))
    [
      Vec.v 5e-324 0. 0.;
      Vec.v 1e-200 0. 0.;
      Vec.v 1e200 0. 0.;
      Vec.v max_float 0. 0.;
    ]

let turned a =
  match Dir.of_vec a with
  | None -> true
  | Some u ->
      Dir.neg (Dir.neg u) = u
      && Dir.dot u (Dir.neg u) = -.Dir.dot u u
      && near 0x1p-50 (Dir.dot u u) 1.

(* Many directions come out longer than 1: by how little is what others may
   count on. *)
let longer () =
  let state = Random.State.make [| 11 |] in
  let number _ = Random.State.float state 2. -. 1. in
  let drawn _ =
    Dir.of_vec_or Dir.x (Vec.v (number ()) (number ()) (number ()))
  in
  let directions = List.init 20_000 drawn in
  let longer = List.filter (fun d -> Dir.dot d d > 1.) directions in
  Alcotest.(check bool) "many" true (List.length longer > 1000);
  List.iter
    (fun (d : Dir.t) ->
      let over = Q.sub (squares (d :> Vec.t)) Q.one in
      if Q.gt over (Exact.power (-50)) || Dir.dot d d > 1. +. 0x1p-50 then
        Alcotest.failf "%s" (show (d :> Vec.t)))
    longer

let suite =
  ( "directions",
    [
      Law.law ~count:10000 ~print:show
        "G12: a direction has length 1 and points the same way, at any size" vec
        unit;
      Law.example
        "G11: directions that round to longer than 1 do so by 2^-51 at most"
        longer;
      Law.law ~count:5000
        ~print:(fun (a, k) -> Printf.sprintf "%s %d" (show a) k)
        "a power of two changes no bit"
        (QCheck2.Gen.pair ordinary (QCheck2.Gen.int_range (-300) 300))
        scaled;
      Law.law ~count:5000 ~print:show "turning twice changes nothing" vec turned;
      Law.example "what has no direction has none" none;
      Law.example "G12: the smallest and the largest vectors have one" extremes;
      Law.law ~count:5000
        ~print:(fun (a, k) -> Printf.sprintf "%s by 2^%d" (show a) k)
        "what is divided by a plain root has the bits of what is brought near \
         1 first"
        QCheck2.Gen.(
          pair
            (map
               (fun ((x, y), z) -> Vec.v x y z)
               (let number = Draw.uniform (-2.) 2. in
                pair (pair number number) number))
            (int_range (-450) 450))
        as_plain_squares;
    ] )

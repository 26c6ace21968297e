open Candor_sample
open Candor_oracle
open QCheck2

let weights = Float.Array.of_list
let make ws = Option.get (Distribution.make (weights ws))
let count_of = List.length
let show ws = String.concat " " (List.map (Printf.sprintf "%h") ws)

(* {1 One row} *)

let none () =
  let check name ws =
    Alcotest.(check bool) name true (Distribution.make (weights ws) = None)
  in
  check "no weights" [];
  check "all zero" [ 0.; 0.; -0. ];
  check "negative" [ -1.; Float.nan ];
  check "infinite" [ 1.; infinity ]

let no_weights () =
  let t = make [ -1.; 2.; Float.nan; 2. ] in
  Alcotest.(check (list (float 0.)))
    "probabilities" [ 0.; 0.5; 0.; 0.5 ]
    (List.init 4 (Distribution.probability t))

let examples =
  [
    [ 1. ];
    [ 0.; 2.; 0. ];
    [ 1.; 2.; 3.; 4.; 0.; 0.; 10. ];
    [ 1e308; 1e308; 1e308 ];
    [ 5e-324; 1.5e-323; 0. ];
    List.init 1000 (fun i -> float_of_int (i mod 7));
  ]

let chi_square () =
  List.iteri
    (fun k ws ->
      let t = make ws in
      let bin i = (Distribution.sample t (Agreement.position i).u).index in
      Chi_square.(
        against
          (Printf.sprintf "example %d" k)
          (Array.of_list (List.map (fun w -> w *. 0x1p-20) ws))
          (count (count_of ws) 100_000 bin)))
    (List.filter (fun ws -> List.hd ws <> 5e-324) examples)

(* What is left of u is as uniform as u was. *)
let leftovers () =
  let t = make [ 1.; 0.; 3.; 0.5; 2. ] in
  let bin i =
    let c = Distribution.sample t (Agreement.position i).u in
    (16 * c.index) + int_of_float (16. *. c.rest)
  in
  let expected = Array.init 80 (fun i -> [| 1.; 0.; 3.; 0.5; 2. |].(i / 16)) in
  Chi_square.(against "index and rest" expected (count 80 100_000 bin))

let some_weights =
  let open Gen in
  let weight =
    oneof [ Draw.uniform 0. 1.; Draw.wide (-30.) 30.; return 0.; Draw.small 3 ]
  in
  let+ ws = list_size (int_range 1 40) weight and+ last = Draw.wide (-5.) 5. in
  ws @ [ last ]

let unit =
  Gen.map
    (fun u -> Float.min u (Float.pred 1.))
    (Gen.oneof
       [
         Draw.uniform 0. 1.;
         Draw.wide (-18.) (-1.);
         Draw.pick [ 0.; Float.pred 1.; 0.5; 5e-324 ];
       ])

let case = Gen.pair some_weights unit
let show_case (ws, u) = Printf.sprintf "%h in %s" u (show ws)
let law name gen print f = Law.law ~count:1500 ~print name gen f
let q = Q.of_float
let weight_q w = if w > 0. then q w else Q.zero
let total ws = List.fold_left (fun s w -> Q.add s (weight_q w)) Q.zero ws

let exact_probability ws i =
  Q.to_float (Q.div (weight_q (List.nth ws i)) (total ws))

let near e a b = Float.abs (a -. b) <= e *. Float.abs b

let probabilities (ws, _) =
  let t = make ws in
  Distribution.probability t (-1) = 0.
  && Distribution.probability t (count_of ws) = 0.
  && List.for_all
       (fun i ->
         let p = exact_probability ws i in
         near 0x1p-51 (Distribution.probability t i) p)
       (List.init (count_of ws) Fun.id)

(* The sums before and after what is taken have u between them. *)
let taken (ws, u) =
  let { Distribution.index; rest; probability } =
    Distribution.sample (make ws) u
  in
  let before = total (List.filteri (fun i _ -> i < index) ws) in
  let after = Q.add before (weight_q (List.nth ws index)) in
  let x = Q.mul (q u) (total ws) in
  let slack = Q.mul (total ws) (q 0x1p-51) in
  List.nth ws index > 0.
  && probability = Distribution.probability (make ws) index
  && 0. <= rest && rest < 1.
  && Q.leq before (Q.add x slack)
  && Q.leq x (Q.add after slack)
  && Q.leq
       (Q.abs (Q.sub x (Q.add before (Q.mul (q rest) (Q.sub after before)))))
       slack

let grows (ws, u) =
  let t = make ws in
  let v = Float.min (Float.pred 1.) (u *. 1.25) in
  (Distribution.sample t u).index <= (Distribution.sample t v).index

let scales (ws, u) =
  let times k = List.map (fun w -> Float.ldexp w k) ws in
  let choice k = Distribution.sample (make (times k)) u in
  choice 0 = choice 300 && choice 0 = choice (-300)

(* {1 Squares} *)

let grid =
  let open Gen in
  let* columns = int_range 1 9 and* ws = some_weights in
  return (columns, ws)

let square (columns, ws) =
  Option.get (Distribution.square ~columns (weights ws))

let rows (columns, ws) = (count_of ws + columns - 1) / columns

let cell_density ((columns, ws) as g) i =
  if i >= count_of ws then 0.
  else exact_probability ws i *. float_of_int (columns * rows g)

let middle ((columns, _) as g) i =
  let part k n = (float_of_int k +. 0.5) /. float_of_int n in
  { Pattern.u = part (i mod columns) columns; v = part (i / columns) (rows g) }

let densities ((columns, _) as g) =
  let s = square g in
  List.for_all
    (fun i ->
      near 0x1p-48 (Distribution.density s (middle g i)) (cell_density g i))
    (List.init (columns * rows g) Fun.id)

(* Unless it is next to the edge of a cell, what is sampled has its density. *)
let placed (((columns, _) as g), (u, v)) =
  let s = square g in
  let { Distribution.u; v; density } = Distribution.place s { Pattern.u; v } in
  let inside x n =
    let f = Float.rem (x *. float_of_int n) 1. in
    0x1p-40 < f && f < 1. -. 0x1p-40
  in
  0. <= u && u < 1. && 0. <= v && v < 1. && density > 0.
  && ((not (inside u columns && inside v (rows g)))
     || Float.equal density (Distribution.density s { Pattern.u; v }))

let squares_fill () =
  let g = (3, [ 1.; 0.; 2.; 0.; 0.; 0.; 5.; 1.; 1.; 0.25 ]) in
  let s = square g in
  let n = 24 in
  let at i = (float_of_int i +. 0.5) /. float_of_int n in
  let expected =
    Array.init (n * n) (fun i ->
        Distribution.density s { Pattern.u = at (i mod n); v = at (i / n) })
  in
  let bin i =
    let p = Distribution.place s (Agreement.position i) in
    let cell x = int_of_float (x *. float_of_int n) in
    (n * cell p.v) + cell p.u
  in
  Agreement.close "all of it" ~within:1e-12
    (float_of_int (n * n))
    (Array.fold_left ( +. ) 0. expected);
  Chi_square.(against "the square" expected (count (n * n) 100_000 bin))

(* u times a sum of 2^-1074 rounds to all of it. *)
let faint_row () =
  let s = square (3, [ 1e-323; 0.; 0.; 1.; 1.; 1. ]) in
  let p = Distribution.place s { Pattern.u = 0.9; v = 0. } in
  Alcotest.(check bool) "in the first cell" true (p.u <= 1. /. 3. && p.v < 0.5);
  Alcotest.(check bool) "density" true (p.density > 0.)

let outside () =
  let s = square (2, [ 1.; 1.; 1.; 1. ]) in
  List.iter
    (fun (u, v) ->
      Alcotest.(check (float 0.))
        "outside" 0.
        (Distribution.density s { Pattern.u; v }))
    [ (-0.1, 0.5); (0.5, -0.1); (1., 0.5); (0.5, 1.) ];
  let check = Alcotest.(check bool) "no square" true in
  check (Distribution.square ~columns:2 (weights [ 0.; 0.; 0. ]) = None);
  check (Distribution.square ~columns:4 (weights []) = None)

let suite =
  ( "distributions",
    [
      Law.example "weights that are all zero make none" none;
      Law.example "negative weights and nan count as 0" no_weights;
      Law.example "each index comes as often as its weight says" chi_square;
      Law.example "what is left of u is uniform, whatever is taken" leftovers;
      law "probabilities are weights over their exact sum" case show_case
        probabilities;
      law "G25: u lies between the sums before and after what it takes" case
        show_case taken;
      law "the choice grows with u" case show_case grows;
      law "weights times 2^k make the same choices" case show_case scales;
      law "densities are the exact ones" grid
        (fun (c, ws) -> Printf.sprintf "%d to a row: %s" c (show ws))
        densities;
      law "G25: places are in the square and have the density that is said"
        (Gen.pair grid (Gen.pair unit unit))
        (fun ((c, ws), (u, v)) ->
          Printf.sprintf "%h %h, %d to a row: %s" u v c (show ws))
        placed;
      Law.example "the square is filled as its density says" squares_fill;
      Law.example "a row of the least weight there is holds its places"
        faint_row;
      Law.example "outside of the square there is nothing" outside;
    ] )

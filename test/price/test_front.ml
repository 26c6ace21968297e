open Candor_oracle
open Candor_cost
open QCheck2

let point = Gen.map2 (fun seconds error -> { Front.seconds; error })

let drawn =
  Gen.(
    list_size (int_range 0 30)
      (point
         (Draw.pick [ 0.; 1.; 2.; 3.; 5.; 8.; infinity ])
         (Draw.pick [ 0.; 0.5; 1.; 2.; 4.; 7.; nan ])))

let print ps =
  String.concat " "
    (List.map
       (fun { Front.seconds; error } -> Printf.sprintf "(%g %g)" seconds error)
       ps)

let value x = if Float.is_nan x then infinity else x

let worse_or_equal (p : Front.point) (q : Front.point) =
  value q.seconds <= value p.seconds && value q.error <= value p.error

let dominated p q =
  worse_or_equal p q
  && (value q.seconds < value p.seconds || value q.error < value p.error)

let kept_are_best points =
  let kept = Front.pareto points in
  List.for_all2
    (fun p keep -> keep = not (List.exists (dominated p) points))
    points kept

let others_are_beaten points =
  let kept = Front.pareto points in
  let best = List.filteri (fun i _ -> List.nth kept i) points in
  List.for_all2
    (fun p keep -> keep || List.exists (dominated p) best)
    points kept

let knee name expected points =
  let points =
    List.map (fun (seconds, error) -> { Front.seconds; error }) points
  in
  Alcotest.(check (option int)) name expected (Front.knee points)

let knees () =
  knee "a sharp bend" (Some 1) [ (1., 10.); (2., 1.); (10., 0.5); (20., 0.) ];
  knee "a later one" (Some 2) [ (0., 10.); (1., 6.); (2., 2.); (9., 1.) ];
  knee "a straight line" None [ (0., 2.); (1., 1.); (2., 0.) ];
  knee "above the chord" None [ (0., 2.); (1., 1.9); (2., 0.) ];
  knee "nothing" None [];
  knee "one" None [ (1., 1.) ];
  knee "no better" None [ (1., 1.); (2., 1.) ];
  knee "unknown errors" None [ (1., nan); (2., nan) ];
  (* e = t^-1/2 on 1 .. 64: the tangent is parallel to the chord where
     t^(3/2) = 63/2 · 8/7 = 36, near t = 10.9. *)
  knee "the inverse square root" (Some 3)
    (List.map (fun t -> (t, t ** -0.5)) [ 1.; 2.; 4.; 10.9; 20.; 40.; 64. ])

(* Stretching either axis moves no knee. *)
let stretched points =
  let times k (p : Front.point) =
    { Front.seconds = k *. p.seconds; error = p.error *. 0x1p-7 }
  in
  Front.knee points = Front.knee (List.map (times 0x1p5) points)

let finite =
  Gen.(
    list_size (int_range 0 12)
      (point
         (map float_of_int (int_range 0 20))
         (map float_of_int (int_range 0 20))))

let suite =
  ( "front",
    [
      Law.law ~print "what nothing beats is kept, and nothing else" drawn
        kept_are_best;
      Law.law ~print "what is left out is beaten by something kept" drawn
        others_are_beaten;
      Law.example "knees are where curves bend" knees;
      Law.law ~print "knees do not depend on units" finite stretched;
    ] )

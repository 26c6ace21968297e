open Candor_number
open Candor_oracle
open Numbers
open QCheck2
module V = Running_variance

let of_list = List.fold_left V.add V.empty

let exact_mean xs =
  let sum = List.fold_left (fun s x -> Q.add s (Exact.q x)) Q.zero xs in
  Q.div sum (Q.of_int (List.length xs))

let exact_variance xs =
  let mean = exact_mean xs in
  let square x =
    let d = Exact.(q x - mean) in
    Exact.(d * d)
  in
  let squares = List.fold_left (fun s x -> Q.add s (square x)) Q.zero xs in
  Q.div squares (Q.of_int (List.length xs - 1))

(* Within (n + 16) 2^-51. *)
let right xs v =
  let n = List.length xs in
  let bound = Q.mul (Q.of_int (n + 16)) (Exact.power (-51)) in
  V.count v = n
  &&
  match V.variance v with
  | None -> n < 2
  | Some variance ->
      n >= 2 && relative bound (Exact.q variance) (exact_variance xs)

let right_mean xs v =
  match V.mean v with
  | None -> xs = []
  | Some mean ->
      let most = List.fold_left (fun m x -> Float.max m (Float.abs x)) 0. xs in
      let off = Q.abs Exact.(q mean - exact_mean xs) in
      Q.leq off Exact.(power (-50) * q most)

(* Spreads from that of the mean down to 2^-40 of it. *)
let samples =
  let open Gen in
  let* mean = Draw.signed (Draw.wide (-3.) 9.) and* k = int_range 0 40 in
  let spread = Float.ldexp mean (-k) in
  list_size (int_range 0 50)
    (map (fun x -> mean +. (spread *. x)) (Draw.uniform (-1.) 1.))

let show = Print.list (Printf.sprintf "%h")

let hard () =
  let xs =
    List.init 1000 (fun i -> 1e6 +. if i mod 2 = 0 then 1e-3 else -1e-3)
  in
  Alcotest.(check bool) "right" true (right xs (of_list xs));
  let variance = Option.get (V.variance (of_list xs)) in
  Alcotest.(check (float 1e-12)) "1e-6" (1e-6 *. 1000. /. 999.) variance

(* The samples as they are, 1e6 + or - 1e-3 rounded, have no other variance. *)
let million () =
  let a = 1e6 +. 1e-3 and b = 1e6 -. 1e-3 in
  let rec grow n v = if n = 0 then v else grow (n - 1) (V.add (V.add v a) b) in
  let half = Exact.((q a - q b) / two) in
  let truth = Q.to_float Exact.(half * half * Q.of_ints 1_000_000 999_999) in
  let variance = Option.get (V.variance (grow 500_000 V.empty)) in
  Alcotest.(check (float (1e-12 *. truth))) "variance" truth variance

let constant () =
  List.iter
    (fun x ->
      let xs = of_list (List.init 1000 (fun _ -> x)) in
      let some = Alcotest.(check (option (float 0.))) in
      some "variance" (Some 0.) (V.variance xs);
      some "mean" (Some x) (V.mean xs);
      some "of parts" (Some 0.) (V.variance (V.join xs (V.join V.empty xs))))
    [ 0.; 0.1; -1e9; 1. /. 3.; 1e200; 5e-324 ]

let few () =
  let none = Alcotest.(check (option (float 0.))) in
  none "mean of none" None (V.mean V.empty);
  none "variance of none" None (V.variance V.empty);
  none "variance of one" None (V.variance (of_list [ 3. ]));
  none "mean of one" (Some 3.) (V.mean (of_list [ 3. ]));
  none "variance of two" (Some 2.) (V.variance (of_list [ 3.; 5. ]));
  Alcotest.(check int) "count" 2 (V.count (of_list [ 3.; 5. ]))

let odd () =
  List.iter
    (fun x ->
      let v = of_list [ 1.; x; 2. ] in
      Alcotest.(check bool)
        "loud" true
        (Float.is_nan (Option.get (V.variance v))))
    [ nan; infinity; neg_infinity ]

let law name f = Law.law ~count:5000 ~print:show name samples f

let suite =
  ( "running variances",
    [
      Law.example "G20: samples of 1e6 ± 1e-3 vary by 1e-6" hard;
      Law.example "G20: a million of them too" million;
      law "G20: a variance is right within (n + 16)·2^-51, whatever the mean"
        (fun xs -> right xs (of_list xs));
      law "a mean is right within 4 units of the largest sample" (fun xs ->
          right_mean xs (of_list xs));
      Law.law ~count:5000
        ~print:(fun (xs, ys) -> show xs ^ " and " ^ show ys)
        "samples joined are as good as samples added" (pair samples)
        (fun (xs, ys) ->
          let v = V.join (of_list xs) (of_list ys) in
          right (xs @ ys) v && right_mean (xs @ ys) v);
      Law.example "equal samples do not vary at all" constant;
      Law.example "fewer than two samples have no variance" few;
      Law.example "samples that are not finite are not hidden" odd;
    ] )

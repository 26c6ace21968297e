open Candor_image
open Support
open QCheck2

let plane ~width ~height numbers = Plane.init ~width ~height (Array.get numbers)
let numbers n = Gen.(array_size (pure n) (float_range (-2.) 2.))

let drawn =
  let open Gen in
  let* width = side in
  let* height = side in
  let+ numbers = numbers (width * height) in
  plane ~width ~height numbers

let kernel =
  let open Gen in
  let* radius = int_bound 4 in
  let+ weights = numbers ((2 * radius) + 1) in
  Float.Array.of_list (Array.to_list weights)

let at p x y =
  let clamp most v = Int.max 0 (Int.min (most - 1) v) in
  let x = clamp (Plane.width p) x and y = clamp (Plane.height p) y in
  Plane.get p ((y * Plane.width p) + x)

let every p holds =
  let all n f = List.for_all f (List.init n Fun.id) in
  all (Plane.height p) (fun y -> all (Plane.width p) (fun x -> holds x y))

let same p q =
  Plane.width p = Plane.width q
  && Plane.height p = Plane.height q
  && every p (fun x y -> at p x y = at q x y)

let weighed kernel p x y =
  let radius = Float.Array.length kernel / 2 in
  let sum = ref 0. in
  Float.Array.iteri
    (fun k weight -> sum := !sum +. (weight *. at p (x + k - radius) y))
    kernel;
  !sum

let by_definition (kernel, p) =
  let turned = Plane.across kernel p in
  Plane.width turned = Plane.height p
  && Plane.height turned = Plane.width p
  && every p (fun x y -> at turned y x = weighed kernel p x y)

let only_one = Float.Array.make 1 1.
let upright p = same p (Plane.across only_one (Plane.across only_one p))

let cut_and_stacked (first, p) =
  let height = Plane.height p in
  let first = 1 + (first mod height) in
  if first = height then same p (Plane.rows ~first:0 ~count:height p)
  else
    let top = Plane.rows ~first:0 ~count:first p
    and rest = Plane.rows ~first ~count:(height - first) p in
    same p (Plane.stack [ top; rest ])

let by_hand () =
  let p = plane ~width:2 ~height:2 [| 1.; 2.; 4.; 9. |] in
  let number = Alcotest.float 0. in
  Alcotest.check number "mean" 4. (Plane.mean p);
  Alcotest.check number "sum" 18. (Plane.get (Plane.add p p) 3);
  let a, b, c =
    Plane.init3 ~width:2 ~height:3 (fun x y ->
        (float_of_int x, float_of_int y, 7.))
  in
  Alcotest.check number "first" 1. (at a 1 2);
  Alcotest.check number "second" 2. (at b 1 2);
  Alcotest.check number "third" 7. (at c 1 2)

let refuses name f =
  match f () with
  | (_ : Plane.t) -> Alcotest.fail name
  | exception Invalid_argument _ -> ()

let misuse () =
  let p = plane ~width:2 ~height:1 [| 1.; 2. |] in
  let q = Plane.across only_one p in
  refuses "empty" (fun () -> Plane.init ~width:0 ~height:1 (fun _ -> 0.));
  refuses "sizes" (fun () -> Plane.add p q);
  refuses "even" (fun () -> Plane.across (Float.Array.make 2 1.) p);
  refuses "rows" (fun () -> Plane.rows ~first:1 ~count:1 p);
  refuses "no rows" (fun () -> Plane.rows ~first:0 ~count:0 p);
  refuses "nothing" (fun () -> Plane.stack []);
  refuses "widths" (fun () -> Plane.stack [ p; q ])

let tests =
  [
    unit "means, sums and planes made together, by hand" by_hand;
    law "a kernel weighs a row as defined, and transposes"
      (Gen.pair kernel drawn) by_definition;
    law "transposed twice, a plane is upright" drawn upright;
    law "rows stacked again are the plane"
      Gen.(pair (int_bound 8) drawn)
      cut_and_stacked;
    unit "misuse is refused" misuse;
  ]

let suite = ("plane", tests)

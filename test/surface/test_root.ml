open Candor_surface
open Candor_number
open Candor_oracle
open QCheck2

(* Exact numbers of either kind, and questions asked with them. The parts of a
   number are doubles that are added up. *)
type number = float list

type case = {
  a : number;
  b : number;
  c : number;
  falling : bool;
  v : number;
  w : number;
}

let rational x = List.fold_left (fun s y -> Q.add s (Q.of_float y)) Q.zero x

let expansion x =
  List.fold_left
    (fun s y -> Expansion.add s (Expansion.of_float y))
    (Expansion.of_float 0.) x

let show_number x = String.concat " + " (List.map (Printf.sprintf "%h") x)

let show { a; b; c; falling; v; w } =
  Printf.sprintf "a = %s\nb = %s\nc = %s\n%s\nv = %s\nw = %s" (show_number a)
    (show_number b) (show_number c)
    (if falling then "falling" else "rising")
    (show_number v) (show_number w)

let answer { a; b; c; falling; v; w } =
  let x = expansion in
  Root.is_within (x a, x b, x c) ~falling (x v, x w)

(* {1 The truth} *)

(* Where the polynomial falls, or else rises; both for a double root. *)
let root { a; b; c; falling; _ } =
  let a = rational a and b = rational b and c = rational c in
  match Exact_root.of_quadratic (a, b, c) with
  | [ only ] when falling = (Q.sign b < 0) -> Some only
  | [ lower; upper ] -> Some (if falling = (Q.sign a > 0) then lower else upper)
  | _ -> None

let truth case =
  let v = rational case.v and w = rational case.w in
  let compare t =
    match Q.sign w with
    | 0 -> Q.sign v <= 0
    | s -> s * Exact_root.compare t Q.(neg v / w) <= 0
  in
  Option.map compare (root case)

let decides case =
  match truth case with None -> true | Some truth -> answer case = truth

(* {1 Cases} *)

let scaled k x = List.map (fun y -> Float.ldexp y k) x
let whole n = Gen.map float_of_int (Gen.int_range (-n) n)
let positive n = Gen.map float_of_int (Gen.int_range 1 n)

(* The question v + t w <= 0 about t = p/q, or t a trifle off. *)
let plane_at p q =
  let open Gen in
  let* k = map2 ( *. ) Draw.sign (positive 5) in
  let* off =
    Draw.either 60 (return [])
      (map (fun x -> [ x ]) (Draw.signed (Draw.power (-120) 2)))
  in
  return (-.(k *. p) :: off, [ k *. q ])

let any_plane =
  let open Gen in
  let* v = whole 6 and* w = whole 4 in
  return ([ v ], [ w ])

let finish a b c planes =
  let open Gen in
  let* v, w = planes and* falling = bool in
  let* k = int_range (-60) 60 and* l = int_range (-60) 60 in
  let at = scaled k in
  return
    { a = at a; b = at b; c = at c; falling; v = scaled l v; w = scaled l w }

(* k (q t - p) (s t - r), asked about one of its roots. *)
let planted =
  let open Gen in
  let* p = whole 9 and* q = positive 5 and* r = whole 9 and* s = positive 5 in
  let* double = bool in
  let r, s = if double then (p, q) else (r, s) in
  let* k = map2 ( *. ) Draw.sign (positive 3) in
  let b = -.(k *. ((q *. r) +. (s *. p))) /. 2. in
  finish
    [ k *. q *. s ]
    [ b ]
    [ k *. p *. r ]
    (oneof [ plane_at p q; plane_at r s; any_plane ])

(* 2 b t + c, asked about its root -c/2b. *)
let linear =
  let open Gen in
  let* b = map2 ( *. ) Draw.sign (positive 6) and* c = whole 9 in
  let* case =
    finish [ 0. ] [ b ] [ c ] (oneof [ plane_at (-.c) (2. *. b); any_plane ])
  in
  return { case with falling = b < 0. }

(* A plane a rounding error from a root that mostly is no double. *)
let number = Gen.oneof [ whole 9; Draw.uniform (-3.) 3. ]

let irrational =
  let open Gen in
  let* a = number and* b = number and* c = number in
  let* fine = Draw.signed (Draw.power (-90) (-50)) in
  let near =
    let d = (b *. b) -. (a *. c) in
    let* s = Draw.sign and* w = oneof [ return 1.; number ] in
    let t = (-.b +. (s *. sqrt (Float.max 0. d))) /. a in
    let* t = Draw.nudged (return (if Float.is_finite t then t else 1.)) in
    let high = -.(t *. w) in
    return ([ high; -.Float.fma t w high ], [ w ])
  in
  finish [ a ] [ b; fine ] [ c ] (oneof [ near; any_plane ])

(* Almost a double root: the discriminant is 0, or off by the least. *)
let tangent =
  let open Gen in
  let* p = whole 9 and* q = positive 5 in
  let* off =
    Draw.either 40 (return [])
      (map (fun x -> [ x ]) (Draw.signed (Draw.power (-140) (-40))))
  in
  finish
    [ q *. q ]
    [ -.(p *. q) ]
    ((p *. p) :: off)
    (oneof [ plane_at p q; any_plane ])

(* {1 Which root is which} *)

(* With r = -(b + sign(b) sqrt(b^2 - ac)), the slope at c/r and at r/a. *)
let named_as_told (a, b, c) =
  let a' = Exact.q a and b' = Exact.q b and c' = Exact.q c in
  let open Exact in
  let d = (b' * b') - (a' * c') in
  if Q.sign d <= 0 then true
  else
    let s = Exact.sqrt d in
    let r = Q.neg (if b >= 0. then b' + s else b' - s) in
    let falls t = Q.sign ((a' * t) + b') < 0 in
    Root.falls ~b First = falls (c' / r)
    && (a = 0. || Root.falls ~b Second = falls (r / a'))

(* {1 By hand} *)

let rows () =
  let ask a b c falling v w =
    answer { a = [ a ]; b = [ b ]; c = [ c ]; falling; v = [ v ]; w = [ w ] }
  in
  let check name expected found = Alcotest.(check bool) name expected found in
  (* t^2 - 1 falls at -1 and rises at 1. *)
  check "t = -1 is at most -1" true (ask 1. 0. (-1.) true 1. 1.);
  check "t = -1 is not below -2" false (ask 1. 0. (-1.) true 2. 1.);
  check "t = 1 is at most 1" true (ask 1. 0. (-1.) false (-1.) 1.);
  check "t = 1 is at least 1" true (ask 1. 0. (-1.) false 1. (-1.));
  check "t = 1 is not at most 0" false (ask 1. 0. (-1.) false 0. 1.);
  check "t = -1 is not at least 0" false (ask 1. 0. (-1.) true 0. (-1.));
  (* 1 - t^2 rises at -1 and falls at 1. *)
  check "turned over, t = 1 is at most 1" true (ask (-1.) 0. 1. true (-1.) 1.);
  check "turned over, t = -1 is at most 0" true (ask (-1.) 0. 1. false 0. 1.);
  (* (t - 2)^2 *)
  List.iter
    (fun falling ->
      check "a double root on the plane" true (ask 1. (-2.) 4. falling (-2.) 1.);
      check "a double root beyond it" false (ask 1. (-2.) 4. falling (-1.) 1.);
      check "a double root before it" true (ask 1. (-2.) 4. falling (-3.) 1.);
      check "along the plane, within" true (ask 1. (-2.) 4. falling 0. 0.);
      check "along the plane, without" false (ask 1. (-2.) 4. falling 5e-324 0.))
    [ true; false ]

let law ?(count = 5000) name gen holds =
  Law.law ~count ~print:show name gen holds

(* Which cases have a root depends on what was drawn; they are not few. *)
let enough gen () =
  let rand = Random.State.make [| Law.seed |] in
  let drawn = Gen.generate ~rand ~n:1000 gen in
  let truths = List.filter_map truth drawn in
  let share = List.length (List.filter Fun.id truths) in
  Alcotest.(check bool) "roots" true (List.length truths > 400);
  Alcotest.(check bool) "within" true (share > 100);
  Alcotest.(check bool) "beyond" true (List.length truths - share > 100)

let suite =
  ( "root",
    [
      law "a rational root is compared exactly, ties and double roots too"
        planted decides;
      law "the root of a line is compared exactly" linear decides;
      law "a root a rounding error from the plane is told from one on it"
        irrational decides;
      law "two roots that almost fall together are told apart" tangent decides;
      Law.example "roots compared by hand" rows;
      Law.law ~count:5000
        ~print:(fun (a, b, c) -> Printf.sprintf "%h t^2 + 2 %h t + %h" a b c)
        "the polynomial falls at the root that is said to"
        Gen.(
          triple
            (oneof [ number; return 0. ])
            (oneof [ number; return (-0.) ])
            number)
        named_as_told;
      Law.example "the planted questions go both ways" (enough planted);
      Law.example "those about lines go both ways" (enough linear);
      Law.example "those a rounding error off go both ways" (enough irrational);
      Law.example "those about tangents go both ways" (enough tangent);
    ] )

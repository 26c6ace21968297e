open Candor_oracle
open Candor_cost
open QCheck2

let xs = [ 1.; 2.; 4.; 8.; 16.; 32. ]
let close a b = Float.abs (a -. b) <= 1e-9 *. Float.abs b
let drawn = Gen.pair (Draw.uniform 0.1 50.) (Draw.uniform 0.2 2.)
let print (a, b) = Printf.sprintf "%g x^-%g" a b
let points (a, b) = List.map (fun x -> (x, a *. (x ** -.b))) xs

let found (a, b) =
  match Power_law.fit (points (a, b)) with
  | None -> false
  | Some law ->
      close law.a a && close law.b b && law.scatter < 1e-9
      && close (Power_law.at law 3.) (a *. (3. ** -.b))

let undone (a, b) =
  match Power_law.fit (points (a, b)) with
  | None -> false
  | Some law -> (
      match Power_law.inverse law (Power_law.at law 100.) with
      | Some { best; low; high } ->
          close best 100. && low <= best && best <= high
          && high /. low < 1. +. 1e-6
      | None -> false)

(* Points about a known law: the interval holds the true x as often as it says. *)
let kept () =
  let random = Random.State.make [| 7 |] in
  let normal () =
    let u = 1. -. Random.State.float random 1. in
    sqrt (-2. *. log u) *. cos (Random.State.float random (2. *. Float.pi))
  in
  let tries = 2000 in
  let holds () =
    let noisy (x, y) = (x, y *. exp (0.1 *. normal ())) in
    let law = Power_law.fit (List.map noisy (points (10., 0.5))) in
    (* A new point at 64 that is off by chance, too. *)
    let seen = 10. /. 8. *. exp (0.1 *. normal ()) in
    match Option.bind law (fun law -> Power_law.inverse law seen) with
    | Some { low; high; _ } -> low <= 64. && 64. <= high
    | None -> false
  in
  let held = List.length (List.filter holds (List.init tries (fun _ -> ()))) in
  let share = float_of_int held /. float_of_int tries in
  if Float.abs (share -. 0.95) > 0.02 then
    Alcotest.failf "the interval holds %.3f of the time" share

let none () =
  let no name points =
    Alcotest.(check bool) name true (Option.is_none (Power_law.fit points))
  in
  no "no points" [];
  no "one" [ (1., 1.) ];
  no "one x" [ (2., 1.); (2., 3.) ];
  no "no error" [ (1., 0.); (2., 0.); (4., nan); (infinity, 1.) ];
  match Power_law.fit [ (1., 1.); (2., 2.) ] with
  | None -> Alcotest.fail "two points make a law"
  | Some law ->
      Alcotest.(check bool)
        "it does not fall" true
        (Option.is_none (Power_law.inverse law 0.5))

let two () =
  match Power_law.fit [ (1., 4.); (4., 2.) ] with
  | None -> Alcotest.fail "no law"
  | Some law -> (
      match Power_law.inverse law 1. with
      | Some { best; low; high } ->
          Alcotest.(check (float 1e-9)) "best" 16. best;
          Alcotest.(check bool)
            "known to be anything" true
            (low = 0. && high = infinity)
      | None -> Alcotest.fail "no x")

let suite =
  ( "power law",
    [
      Law.law ~print "a law is found in its own points" drawn found;
      Law.law ~print "the inverse is where the law meets an error" drawn undone;
      Law.example "intervals hold as often as promised" kept;
      Law.example "where there is no law, none is found" none;
      Law.example "two points do not tell how far they are off" two;
    ] )

open Candor_space
open Candor_surface
open Candor_oracle
open Candor_surface_families

(* From 1e9 away the textbook is wrong by the radius of a ball: its t tells which
   math met it. *)
let ball = Surface.sphere (Made.sphere Point.origin 1.) ()
let far = Ray.v (Point.v 0. 0. (-1e9)) (Vec.v 0. 0. 1.)

let t surface =
  match Surface.nearest surface far with
  | Some h -> h.t
  | None -> Alcotest.fail "missed"

let met what expected surface =
  Alcotest.(check (float 0.)) what expected (t surface)

let by_textbook = 1e9
let by_candor = 999999999.
let group ?math s = Surface.group ?math [| s |]

let own () =
  met "a surface alone" by_candor ball;
  met "a group" by_candor (group ball);
  met "a stable group" by_candor (group ~math:Stable ball);
  met "a group by the textbook" by_textbook (group ~math:Textbook ball)

let nested () =
  met "a stable group in one by the textbook" by_candor
    (group ~math:Textbook (group ~math:Stable ball));
  met "one by the textbook in a stable group" by_textbook
    (group ~math:Stable (group ~math:Textbook ball));
  met "three levels" by_textbook
    (group ~math:Stable (group ~math:Stable (group ~math:Textbook ball)))

let moved () =
  let halve =
    Made.get "transform" (Transform.of_steps [ Scale (Vec.v 0.5 0.5 0.5) ])
  in
  let through = Surface.seen_through ~transform:halve in
  let half = group (Surface.sphere (Made.sphere Point.origin 2.) ()) in
  let naive =
    group ~math:Textbook (Surface.sphere (Made.sphere Point.origin 2.) ())
  in
  met "moved, and stable" by_candor (through half);
  met "moved, by the textbook" by_textbook (through naive)

let beside () =
  let s =
    Surface.group
      [|
        group ~math:Textbook ball;
        group (Surface.sphere (Made.sphere (Point.v 0. 0. 1.5) 1.) ());
      |]
  in
  met "each its own: the one behind is in front" 1000000000. s

let names () =
  Alcotest.(check (list string))
    "how they are shown"
    [ "Math.Stable"; "Math.Textbook" ]
    (List.map Math.show [ Stable; Textbook ])

let suite =
  ( "math",
    [
      Law.example "a group's members are met by its math" own;
      Law.example "groups among them have their own" nested;
      Law.example "a moved group keeps its math" moved;
      Law.example "the two may stand side by side" beside;
      Law.example "each has a name" names;
    ] )

open Candor_oracle
open Candor_effect
open Candor_scene_made

let eye =
  Printf.sprintf "(camera (perspective (eye %s) (look-at 0 0 0) (fov-y 40)))"

let outside = eye "0 0 5"
let mirror = "(material (mirror))"
let flat = Some "the only mirror is flat"
let convex = Some "the only mirror is convex and seen from outside"
let ball = Called.ball mirror
let mirrors = Printf.sprintf

let check name expected forms =
  Alcotest.(check (option string))
    name expected
    (Single_mirror.why (Written.scene forms))

let plane = "(quadric (plane (normal 0 1 0) (offset -2)) " ^ mirror ^ ")"

let proved () =
  check "a plane" flat [ outside; plane ];
  check "a flat box" flat
    [ outside; "(box (min 0 0 0) (max 1 1 0) " ^ mirror ^ ")" ];
  check "a triangle" flat
    [ outside; "(triangle (0 0 0) (1 0 0) (0 1 0) " ^ mirror ^ ")" ];
  check "a ball" convex [ outside; ball ];
  check "a box" convex
    [ outside; "(box (min 0 0 0) (max 1 1 1) " ^ mirror ^ ")" ];
  check "a ball by name, among others" convex
    [
      outside;
      "(material m (glazed (color .5) (mirror .3)))";
      Called.ball "(material m)";
      Called.ball "";
      "(group " ^ Called.ball "" ^ ")";
      "(define it " ^ ball ^ ")";
    ]

let unproved () =
  check "none" None [ outside; Called.ball "" ];
  check "two" None [ outside; ball; plane ];
  check "the same twice" None [ outside; ball; ball ];
  check "seen from inside" None [ eye "0 0 .5"; ball ];
  check "from its border" None [ eye "0 0 1"; ball ];
  check "from beside the eye" None [ Called.camera; ball ];
  check "a moving one" None
    [ outside; Called.ball (mirror ^ " (motion 0 0 1)") ];
  check "a cone" None
    [
      outside;
      mirrors "(quadric (cone (apex 0 1 0) (base 0 0 0) (radius 1)) %s)" mirror;
    ];
  check "a group" None [ outside; "(group " ^ ball ^ ")" ];
  check "a group beside it" None [ outside; ball; "(group " ^ ball ^ ")" ];
  check "one used beside it" None
    [ outside; plane; "(define it " ^ ball ^ ")"; "(use it)" ];
  check "a group that is given it" None
    [ outside; plane; "(group " ^ mirror ^ Called.ball "" ^ ")" ]

(* What is said holds: where once is proved, no ray is reflected again. *)
let holds () =
  List.iter
    (fun form ->
      let s =
        Written.scene
          [
            Written.size 16 16;
            outside;
            form;
            "(background 1)";
            "(ambient 1)";
            Called.ball "(motion 0 0 0)";
          ]
      in
      let deep n =
        Written.with_settings (fun x -> { x with depth = Some n }) s
      in
      Alcotest.check Shot.bits form
        (Shot.picture (deep 1))
        (Shot.picture (deep 9)))
    [ plane; "(box (min -2 -2 -2) (max -1 2 2) " ^ mirror ^ ")" ]

let suite =
  ( "single mirrors",
    [
      Law.example "where one reflection is all there is" proved;
      Law.example "where that is not proved" unproved;
      Law.example "then depth 1 is enough" holds;
    ] )

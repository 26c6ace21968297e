open Candor_render

(* A program starts before its clocks do. *)
let forwards () =
  let before = Clock.of_program () in
  let clock = Clock.start () in
  let rec ticks n last =
    let now = Clock.seconds clock in
    if now < last then Alcotest.failf "%h s after %h s" now last
    else if n > 0 then ticks (n - 1) now
    else now
  in
  let spent = ticks 10_000 0. in
  let after = Clock.of_program () in
  Alcotest.(check bool)
    "as long as the program" true
    (spent <= after -. before +. 0x1p-20)

let as_the_system () =
  let clock = Clock.start () and start = Unix.gettimeofday () in
  Unix.sleepf 0.05;
  let spent = Clock.seconds clock in
  let other = Unix.gettimeofday () -. start in
  Alcotest.(check bool) "at least what was slept" true (spent >= 0.05);
  Alcotest.(check bool)
    "no more than passed around it" true
    (spent <= other +. 0.05)

let suite =
  ( "clock",
    [
      Alcotest.test_case "time goes forwards" `Quick forwards;
      Alcotest.test_case "it is in seconds" `Quick as_the_system;
    ] )

open Candor_cost

let counts_down () =
  let b = Budget.start 3600. in
  Alcotest.(check (float 0.)) "whole" 3600. (Budget.whole b);
  let left = Budget.left b and spent = Budget.spent b in
  if not (left > 3000. && left < 3600. && spent >= 0. && spent < 60.) then
    Alcotest.failf "%g left and %g spent at the start" left spent

let ends () =
  let b = Budget.start 1e-9 in
  Alcotest.(check (float 0.)) "nothing is left" 0. (Budget.left b)

let suite =
  ( "budget",
    [
      Candor_oracle.Law.example "most of a budget may be spent at the start"
        counts_down;
      Candor_oracle.Law.example "nothing is left of a budget that is over" ends;
    ] )

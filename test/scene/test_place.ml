open Candor_scene
open Candor_oracle

let place file line column = { Place.file; line; column }

let written () =
  let check expected p =
    Alcotest.(check string) "place" expected (Place.to_string p)
  in
  check "a/b c.scene:12:3" (place "a/b c.scene" 12 3);
  check "default:0:0" Place.unknown

let order () =
  let sorted = [ place "a" 1 9; place "a" 2 1; place "a" 2 3; place "b" 1 1 ] in
  Alcotest.(check bool)
    "sorted" true
    (List.equal Place.equal sorted (List.sort Place.compare (List.rev sorted)))

let suite =
  ( "places",
    [
      Law.example "a place is written file:line:column" written;
      Law.example "places are ordered by file, line and column" order;
    ] )

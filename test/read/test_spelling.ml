open Candor_read
open Text

let distance = Spelling.distance ~most:5

let edits () =
  let check d a b = Alcotest.(check int) (a ^ " " ^ b) d (distance a b) in
  check 0 "radius" "radius";
  check 1 "radious" "radius";
  check 1 "centre" "center";
  check 1 "raduis" "radius";
  check 1 "spehre" "sphere";
  check 3 "" "abc";
  check 3 "abc" "";
  check 3 "ca" "abc"

let word = QCheck2.Gen.(string_size ~gen:(char_range 'a' 'c') (int_range 0 6))

let symmetric =
  law "the distance is the same both ways" (QCheck2.Gen.pair word word)
    (fun (a, b) -> distance a b = distance b a)

let lengths =
  law "the distance is between the difference of the lengths and the longer one"
    (QCheck2.Gen.pair word word) (fun (a, b) ->
      let m = String.length a and n = String.length b in
      let d = Spelling.distance ~most:10 a b in
      abs (m - n) <= d && d <= max m n)

let swaps =
  law "two neighbours that are swapped are one mistake" word (fun a ->
      String.length a < 2
      || distance a
           (Printf.sprintf "%c%c%s" a.[1] a.[0]
              (String.sub a 2 (String.length a - 2)))
         <= 1)

let far () =
  Alcotest.(check int)
    "more than most" 3
    (Spelling.distance ~most:2 "camera" "polygon")

let nearest () =
  let among = [ "center"; "radius"; "material"; "up"; "at" ] in
  let check word meant =
    Alcotest.(check (option string)) word meant (Spelling.nearest word ~among)
  in
  check "radious" (Some "radius");
  check "centre" (Some "center");
  check "banana" None;
  check "x" None;
  check "ut" (Some "up");
  check "radius" None;
  check (String.make 100_000 'a') None

let suite =
  ( "spelling",
    [
      case "an edit is one letter in, out, changed or swapped" edits;
      symmetric;
      lengths;
      swaps;
      case "a large distance is only told to be large" far;
      case "the nearest word must be near for its length" nearest;
    ] )

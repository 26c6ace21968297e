open Candor_image_hidden
open Support
open QCheck2

let words text =
  let s = Scan.v text in
  let rec go read =
    match Scan.word s with "" -> List.rev read | word -> go (word :: read)
  in
  go []

let blank = pick [ " "; "\t"; "\n"; "\r"; "\011"; "\012"; "# a 1 #\n"; "#\n" ]
let gap = Gen.(map (String.concat "") (list_size (int_range 1 4) blank))

let a_word =
  Gen.(
    string_size
      ~gen:(oneof [ char_range '0' '9'; char_range '!' '"' ])
      (int_range 1 9))

(* Words and the text that holds them. *)
let spaced =
  let open Gen in
  let+ first = oneof [ pure ""; gap ]
  and+ parts = list_size (int_bound 6) (pair a_word gap) in
  ( List.map fst parts,
    String.concat "" (first :: List.concat_map (fun (w, g) -> [ w; g ]) parts)
  )

let split =
  law "blanks and comments separate words, and are none" ~count:1000
    ~print:(fun (_, text) -> String.escaped text)
    spaced
    (fun (expected, text) -> words text = expected)

let ends () =
  let check text expected =
    Alcotest.(check (list string)) (String.escaped text) expected (words text)
  in
  check "" [];
  check " # only a comment" [];
  check "P3#comment" [ "P3" ];
  check "a#b\nc" [ "a"; "c" ];
  check "a#b # c\rd\ne" [ "a"; "e" ];
  check "x\000y" [ "x\000y" ];
  let s = Scan.v "one " in
  Alcotest.(check string) "a word" "one" (Scan.word s);
  Alcotest.(check string) "the end" "" (Scan.word s);
  Alcotest.(check string) "still the end" "" (Scan.word s)

let number text = Scan.number (Scan.v text) "the width"
let read_number = Alcotest.(result int string)

let numbers =
  let digits =
    Gen.(
      int_range 0 9 >>= fun n ->
      int_bound (int_of_float (10. ** float_of_int n) - 1))
  in
  law "numbers up to 999999999 are read" ~count:1000 ~print:Print.int digits
    (fun n -> number (Printf.sprintf " %d " n) = Ok n)

let number_ends () =
  let check text expected =
    Alcotest.check read_number text expected (number text)
  in
  check "0" (Ok 0);
  check "007" (Ok 7);
  check "999999999" (Ok 999999999);
  check "12#3" (Ok 12);
  let found w = Error (Printf.sprintf "expected the width, found %S" w) in
  List.iter
    (fun w -> check w (found w))
    [ "1000000000"; "-1"; "+1"; "0x1"; "1_0"; "1."; "1e3"; "x"; "1\000" ];
  check " # none" (Error "the file ends where the width is expected");
  check (String.make 50 '9') (found (String.make 20 '9' ^ "..."))

let left =
  law "what is left counts from behind the last word" ~count:1000
    ~print:(fun (_, text) -> String.escaped text)
    spaced
    (fun (expected, text) ->
      let s = Scan.v text in
      let rest_is_left word =
        let read = Scan.word s in
        let from = String.length text - Scan.left s in
        read = word
        && from >= String.length word
        && String.sub text (from - String.length word) (String.length word)
           = word
      in
      Scan.left s = String.length text
      && List.for_all rest_is_left expected
      && Scan.word s = ""
      && Scan.left s = 0)

let body =
  law "binary data begin behind one separator" ~count:1000
    ~print:Print.(triple String.escaped String.escaped String.escaped)
    Gen.(triple a_word blank (string_size (int_bound 9)))
    (fun (word, separator, data) ->
      let text = word ^ separator ^ data in
      let s = Scan.v text in
      let bytes = String.length data in
      ignore (Scan.word s : string);
      Scan.body s ~bytes = Ok (String.length text - bytes))

let odd_bodies () =
  let check text ~bytes expected =
    let s = Scan.v text in
    ignore (Scan.word s : string);
    Alcotest.check read_number (String.escaped text) expected
      (Scan.body s ~bytes)
  in
  let early ~needed ~left = Error (Scan.ends_early ~needed ~left) in
  check "P6\n\n# " ~bytes:3 (Ok 3);
  check "P6\n more" ~bytes:2 (Ok 3);
  check "P6\n" ~bytes:0 (Ok 3);
  check "P6" ~bytes:0 (Ok 2);
  check "P6" ~bytes:1 (early ~needed:1 ~left:0);
  check "P6\nab" ~bytes:3 (early ~needed:3 ~left:2);
  check "P6#no end" ~bytes:1 (early ~needed:1 ~left:0)

let message () =
  Alcotest.(check string)
    "message" "the file ends early: its pixels need 9 more bytes, 2 are there"
    (Scan.ends_early ~needed:9 ~left:2)

let suite =
  ( "scan",
    [
      split;
      unit "a comment ends a word, the end of the file a comment" ends;
      numbers;
      unit "what is no such number is told" number_ends;
      left;
      body;
      unit "only one separator is skipped, and the length is checked" odd_bodies;
      unit "a file cut short is told what it lacks" message;
    ] )

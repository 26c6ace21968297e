open Candor_read
open Text

let read f text = Mesh_text.reading f text

let words () =
  let rec all t found =
    match Mesh_text.word t with
    | "" when Mesh_text.is_over t -> List.rev found
    | "" ->
        Mesh_text.next_line t;
        all t ("|" :: found)
    | word -> all t (word :: found)
  in
  let check text expected =
    Alcotest.(check (result (list string) string))
      text (Ok expected)
      (read (fun t -> all t []) text)
  in
  check "" [];
  check " a\tb \r\n c" [ "a"; "b"; "|"; "c" ];
  check "a \\\n b\\\r\n c" [ "a"; "b\\"; "|"; "c" ];
  check "a \\\r\n c \\" [ "a"; "c"; "\\" ];
  check "\n\n" [ "|"; "|" ]

let lines () =
  let check text expected =
    Alcotest.(check (result string string))
      text (Error expected)
      (read
         (fun t ->
           Mesh_text.next_line t;
           ignore (Mesh_text.need t "x" : string);
           Mesh_text.refuse t "here")
         text)
  in
  check "a\nb" "line 2: here";
  check "a\n\\\nb" "line 3: here";
  check "a\n" "line 2: expected x, not the end of the line"

let lengths () =
  let check text expected =
    Alcotest.(check (result (float 0.) string))
      text expected
      (read (fun t -> Mesh_text.length t "x") text)
  in
  check "-2.5e-3" (Ok (-2.5e-3));
  check "nan" (Error "line 1: `nan` is not a number");
  check "1e999" (Error "line 1: `1e999` is too large for a number");
  check "1e300"
    (Error "line 1: coordinates must be finite and at most 2^400 in size")

let suite =
  ( "mesh text",
    [
      case "words end at blanks and lines, which a backslash joins" words;
      case "errors tell the line" lines;
      case "numbers are finite and within reach" lengths;
    ] )

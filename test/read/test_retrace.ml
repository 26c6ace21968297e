open Candor_read
open Candor_scene
open Text

let place line column = { Place.file = "x"; line; column }

let check text places expected =
  let spans = Retrace.spans (Source.of_string ~name:"x" text) places in
  Alcotest.(check (list (option (list int))))
    text expected
    (List.map
       (fun p ->
         Option.map
           (fun (s : Span.t) -> [ s.line; s.column; s.offset; s.mark; s.width ])
           (spans p))
       places)

let found () =
  check "(sphere)\n  (box 1)\n((a))\nword"
    [ place 1 1; place 2 3; place 3 1; place 4 1 ]
    [
      Some [ 1; 1; 0; 1; 6 ];
      Some [ 2; 3; 11; 1; 3 ];
      Some [ 3; 1; 19; 0; 1 ];
      Some [ 4; 1; 25; 0; 1 ];
    ]

let lost () =
  check "one\ntwo" [ place 3 1; place 2 1 ] [ None; Some [ 2; 1; 4; 0; 1 ] ]

(* As readers see the form. *)
let as_read =
  law "the span of a form is found again from its place"
    ~print:QCheck2.Print.string
    QCheck2.Gen.(
      map (String.concat "")
        (list_size (int_bound 60)
           (oneof_list
              [ "(sphere 1)"; "\n"; " "; "(box\n)"; "; c\n"; "(a \"(b\nc\")" ])))
    (fun text ->
      let source () = Source.of_string ~name:"x" text in
      let forms = ref [] in
      let keep (s : Located.t) = forms := s.span :: !forms in
      ignore (Forms.iter (source ()) ~bare:true keep : (Span.t, Fault.t) result);
      let places =
        List.map (fun (s : Span.t) -> place s.line s.column) !forms
      in
      let spans = Retrace.spans (source ()) places in
      List.for_all2
        (fun span p -> Option.equal ( = ) (Some span) (spans p))
        !forms places)

(* Texts are read in pieces. *)
let long () =
  let line = "(sphere (center 0 0 0) (radius 1))\n" in
  let text = String.concat "" (List.init 9000 (fun _ -> line)) in
  Alcotest.(check bool)
    "of several pieces" true
    (String.length text > 4 * Source.most);
  Files.with_folder (fun folder ->
      let path = Files.write folder "long.scene" text in
      match Source.open_file path with
      | Error why -> Alcotest.fail why
      | Ok source ->
          Source.close source;
          let n = String.length line in
          let spans = Retrace.spans source [ place 9000 1; place 4500 1 ] in
          let offset p = Option.map (fun (s : Span.t) -> s.offset) (spans p) in
          Alcotest.(check (option int))
            "the last"
            (Some (8999 * n))
            (offset (place 9000 1));
          Alcotest.(check (option int))
            "the middle"
            (Some (4499 * n))
            (offset (place 4500 1)))

let suite =
  ( "retrace",
    [
      case "a place is found again with the head of its form" found;
      case "a line that is no longer there is not" lost;
      as_read;
      case "it may be far down in a file" long;
    ] )

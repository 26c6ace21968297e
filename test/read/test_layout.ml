open Candor_read
open Text

let print s =
  let b = Buffer.create 100 in
  Layout.add b ~indent:0 s;
  Buffer.contents b

let check name expected s = Alcotest.(check string) name expected (print s)
let words n = List.init n (fun i -> Layout.atom (Printf.sprintf "word%03d" i))

let flat () =
  check "empty" "()" (Layout.list []);
  check "form" "(a b (c))"
    (Layout.form "a" [ Layout.atom "b"; Layout.form "c" [] ]);
  check "width 80"
    ("(" ^ String.make 78 'x' ^ ")")
    (Layout.form (String.make 78 'x') [])

let broken () =
  check "words fill lines"
    "(form word000 word001 word002 word003 word004 word005 word006 word007 \
     word008\n\
    \  word009)"
    (Layout.form "form" (words 10));
  check "lists stand alone"
    "(form word000\n\
    \  (a word000 word001 word002 word003)\n\
    \  (b word000 word001 word002 word003) word000\n\
    \  (c))"
    (Layout.form "form"
       [
         Layout.atom "word000";
         Layout.form "a" (words 4);
         Layout.form "b" (words 4);
         Layout.atom "word000";
         Layout.form "c" [];
       ])

let quoted () =
  check "quotes" "(a \"\" \"b c\" \"(\" \";\" \"\\255\")"
    (Layout.list (List.map Layout.atom [ "a"; ""; "b c"; "("; ";"; "\255" ]))

let rec nest n =
  if n = 0 then Layout.atom "x" else Layout.form "group" [ nest (n - 1) ]

let deep () =
  let size n = String.length (print (nest n)) in
  Alcotest.(check bool) "linear" true (size 40_000 < 5 * size 10_000)

let rec show (s : Sexplib0.Sexp.t) =
  match s with
  | Atom a -> Layout.atom a
  | List l -> Layout.list (List.map show l)

let gen : Sexplib0.Sexp.t QCheck2.Gen.t =
  QCheck2.Gen.(
    sized_size (int_range 0 60)
    @@ fix (fun self n : Sexplib0.Sexp.t QCheck2.Gen.t ->
        if n = 0 then
          map (fun a -> Sexplib0.Sexp.Atom a) (string_size (int_range 0 20))
        else
          map
            (fun l -> Sexplib0.Sexp.List l)
            (list_size (int_range 0 6) (self (n / 3)))))

let parses =
  law "what is laid out reads as it was" gen (fun s ->
      match Parsexp.Single.parse_string (print (show s)) with
      | Ok s' -> Sexplib0.Sexp.equal s s'
      | Error _ -> false)

let narrow =
  law "lines of short words hold at most 80 columns"
    (QCheck2.Gen.map
       (fun n -> Layout.form "a" (words n @ [ Layout.form "b" (words n) ]))
       (QCheck2.Gen.int_range 0 100))
    (fun s ->
      List.for_all
        (fun line -> String.length line <= 80)
        (String.split_on_char '\n' (print s)))

let suite =
  ( "layout",
    [
      case "what fits stands on one line" flat;
      case "what does not fit is broken before lists" broken;
      case "words are quoted where they must be" quoted;
      case "deep nesting does not run off to the right" deep;
      parses;
      narrow;
    ] )

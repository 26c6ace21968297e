open Candor_read
open Text

let number head = Fields.field head (Quantity.scalar "N" Rule.any)
let pair = Decode.tuple (Quantity.numbers "X Y" Rule.any)

(* Readers of bodies that show what they have read. *)

let one =
  Fields.(
    fields
      (let+ a = number "a" in
       Printf.sprintf "%g" a))

let two =
  Fields.(
    fields
      (let+ a = number "a" and+ b = number "b" in
       Printf.sprintf "%g %g" a b))

let shown f =
  Fields.(
    fields
      (let+ x = f in
       x))

let check b text x = Piece.reads String.equal b text x
let refuses = Piece.refuses

let required () =
  check one "(f (a 1))" "1";
  refuses one "(f)" [ "1 (f ...) needs (a N)" ];
  refuses one "(f (a 1) (a 2))"
    [ "10 (a ...) is given twice in (f ...); the first is at 1:4" ];
  refuses one "(f (a x))" [ "7 `x` is not a number" ];
  check two "(f (b 2) (a 1))" "1 2";
  refuses two "(f)" [ "1 (f ...) needs (a N)"; "1 (f ...) needs (b N)" ]

let not_required () =
  let b = Quantity.scalar "N" Rule.any in
  let optional = shown (Fields.optional "a" b) in
  let default = shown (Fields.default "a" b 7.) in
  let reads_option = Piece.reads (Option.equal Float.equal) optional in
  reads_option "(f)" None;
  reads_option "(f (a 1))" (Some 1.);
  refuses optional "(f (a 1) (a 1))"
    [ "10 (a ...) is given twice in (f ...); the first is at 1:4" ];
  refuses optional "(f (a))" [ "4 expected (a N), found nothing" ];
  Piece.reads Float.equal default "(f)" 7.;
  Piece.reads Float.equal default "(f (a 1))" 1.;
  refuses default "(f (a x))" [ "7 `x` is not a number" ]

let flags () =
  let b = shown (Fields.present "on") in
  Piece.reads Bool.equal b "(f)" false;
  Piece.reads Bool.equal b "(f (on))" true;
  refuses b "(f (on yes))" [ "4 expected (on), found 1 word" ];
  refuses b "(f (on) (on))"
    [ "9 (on ...) is given twice in (f ...); the first is at 1:4" ]

let sums = Piece.reads (List.equal Float.equal)

let listed () =
  let v = Decode.map_value (fun a -> a.(0) +. a.(1)) pair in
  let b = shown (Fields.items v) in
  sums b "(f)" [];
  sums b "(f (1 2) (3 4) (5 6))" [ 3.; 7.; 11. ];
  refuses b "(f (1 2) (1 x) (3))"
    [ "13 `x` is not a number"; "16 expected (X Y), found 1 word" ];
  let mixed =
    Fields.(
      fields
        (let+ a = number "a" and+ l = items v in
         a :: l))
  in
  sums mixed "(f (1 2) (a 9) (3 4))" [ 9.; 3.; 7. ]

let only_one () =
  let v = Decode.map_value (fun a -> a.(0) +. a.(1)) pair in
  let b = shown (Fields.item "corner" v) in
  Piece.reads Float.equal b "(f (1 2))" 3.;
  refuses b "(f)" [ "1 (f ...) needs one corner, not none; expected (X Y)" ];
  refuses b "(f (1 2) (3 4) (5 6))"
    [ "1 (f ...) needs one corner, not 3; expected (X Y)" ];
  refuses b "(f (1 x))" [ "7 `x` is not a number" ]

let strangers () =
  refuses two "(f (a 1) (b 2) (c 3))"
    [ "16 unknown field `c` in (f ...); expected a or b" ];
  refuses two "(f (a 1) 5 (b 2))"
    [ "10 `5` has no place in (f ...); expected a or b" ];
  refuses two "(f (c 3))" [ "4 unknown field `c` in (f ...); expected a or b" ]

(* {1 Laws} *)

let wide =
  Fields.(
    fields
      (let+ a = number "alpha"
       and+ b = optional "beta" (Quantity.scalar "N" Rule.any)
       and+ c = default "gamma" (Quantity.scalar "N" Rule.any) 7.
       and+ d = present "delta"
       and+ e = items pair in
       (a, b, c, d, e)))

let some_fields =
  let open QCheck2.Gen in
  let number head =
    let+ n = int_bound 99 in
    Printf.sprintf "(%s %d)" head n
  in
  let often field =
    let+ text = field and+ there = int_bound 4 in
    if there = 0 then [] else [ text ]
  in
  let+ a = often (number "alpha")
  and+ b = often (number "beta")
  and+ c = often (number "gamma")
  and+ d = often (pure "(delta)")
  and+ p = map2 (Printf.sprintf "(%d %d)") (int_bound 99) (int_bound 99) in
  a @ b @ c @ d @ [ p ]

let text fields = Printf.sprintf "(f %s)" (String.concat " " fields)

let any_order =
  law ~count:500 "the order of fields does not matter"
    ~print:(fun (a, b) -> text a ^ " " ^ text b)
    QCheck2.Gen.(
      some_fields >>= fun f -> map (fun g -> (f, g)) (shuffle_list f))
    (fun (f, g) -> Piece.body wide (text f) = Piece.body wide (text g))

let at_once =
  law ~count:500 "what is read is what all fields say" ~print:text some_fields
    (fun f ->
      let find head =
        List.find_opt (String.starts_with ~prefix:("(" ^ head)) f
        |> Option.map (fun s -> Scanf.sscanf s "(%s %f)" (fun _ x -> x))
      in
      match (find "alpha", Piece.body wide (text f)) with
      | Some a, (Some (a', b, c, d, [ _ ]), []) ->
          a = a'
          && b = find "beta"
          && c = Option.value (find "gamma") ~default:7.
          && d = List.mem "(delta)" f
      | None, (None, [ "1 (f ...) needs (alpha N)" ]) -> true
      | _, ((Some _ | None), _) -> false)

let suite =
  ( "fields",
    [
      case "a field must be there, once" required;
      case "an optional field may be left out, with a default or none"
        not_required;
      case "a flag is there or not" flags;
      case "items are read in order, among other fields" listed;
      case "a single item is needed, and no more" only_one;
      case "what no field takes is an error" strangers;
      any_order;
      at_once;
    ] )

(* Pieces of the language read by themselves, one form or one value a text. *)

open Candor_read
open Text

(** [first text] is the first s-expression in [text]. *)
let first text =
  let found = ref None in
  let keep s = if Option.is_none !found then found := Some s in
  ignore
    (Forms.iter (Source.of_string ~name:"" text) ~bare:true keep
      : (Span.t, Fault.t) result);
  match !found with
  | Some s -> s
  | None -> Alcotest.failf "nothing to read in %S" text

(** [form text] is the form that [text] begins with. *)
let form text =
  match Form.of_located (first text) with
  | Some form -> form
  | None -> Alcotest.failf "%S is not a form" text

let noted text read =
  let notes = Notes.within (Notes.make ()) (Source.of_string ~name:"" text) in
  let value = read notes in
  let message (e : Error.t) =
    Printf.sprintf "%d %s%s" e.place.column e.message
      (Option.fold e.hint ~none:"" ~some:(fun h -> "; " ^ h))
  in
  (value, List.map message (Notes.report notes).errors)

(** [body b text] is what [b] reads in the form [text], and the messages, each
    behind the column that it is about. *)
let body b text = noted text (fun notes -> Decode.read_body b notes (form text))

(** [value v text] is what [v] reads in [text], and the messages. *)
let value v text = noted text (fun notes -> Decode.read v notes (first text))

(** [reads equal b text x] checks that [text] is read as [x], without a message.
*)
let reads equal b text x =
  let found, messages = body b text in
  Alcotest.(check (list string)) text [] messages;
  is text true (Option.equal equal (Some x) found)

(** [refuses b text messages] checks that [text] is refused with [messages]. *)
let refuses b text expected =
  let found, messages = body b text in
  Alcotest.(check (list string)) text expected messages;
  is (text ^ " gives nothing") true (Option.is_none found)

(** Numbers of all sizes, of either sign, all finite. *)
let number =
  QCheck2.Gen.map
    (fun x -> if Float.is_finite x then x else 1.5)
    (Draw_scene.gen Draw_scene.bits)

let same_bits a b = Int64.equal (Int64.bits_of_float a) (Int64.bits_of_float b)

open Candor_read
open Text

let sorted = List.sort_uniq String.compare

(* What the reader of a scene has to say about its own forms. *)
let known () =
  let form = Top_level.form ~include_:(fun _ _ _ t -> t) in
  Alcotest.(check (list string))
    "the same words"
    (sorted (Decode.words form))
    (sorted Words.top_level)

let once () =
  Alcotest.(check int)
    "as many words as different ones"
    (List.length (sorted Words.top_level))
    (List.length Words.top_level)

(* Inside another form each of them shows that a parenthesis is missing, and a
   word that is not one of them does not. *)
let misplaced () =
  let body = Fields.(fields nothing) in
  let messages word =
    snd (Piece.body body (Printf.sprintf "(some-form (%s))" word))
  in
  List.iter
    (fun word ->
      Alcotest.(check (list string))
        word
        [
          Printf.sprintf
            "12 (%s ...) has no place in (some-form ...); it belongs to the \
             top level: is a `)` missing before it?"
            word;
        ]
        (messages word))
    Words.top_level;
  Alcotest.(check (list string))
    "no such word"
    [ "12 unknown field `radius` in (some-form ...)" ]
    (messages "radius")

let suite =
  ( "words",
    [
      case "the top-level words are those that the scene reader knows" known;
      case "each top-level word is there once" once;
      case "a top-level word in another form means a parenthesis is missing"
        misplaced;
    ] )

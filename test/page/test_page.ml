open Candor_image
open Candor_cost
open Candor_oracle

let read page =
  match Html_reader.read page with
  | Ok events -> events
  | Error why -> Alcotest.fail why

let contains part s =
  let n = String.length part in
  let rec from i =
    i + n <= String.length s && (String.sub s i n = part || from (i + 1))
  in
  from 0

let texts events =
  List.filter_map
    (function Html_reader.Text s -> Some s | Open _ | Close _ -> None)
    events
  |> String.concat "\n"

let attributes events =
  List.concat_map
    (function Html_reader.Open t -> t.attributes | Close _ | Text _ -> [])
    events

let page () = Page.html (Lazy.force Showcase.price)

(* {1 What it says} *)

let says () =
  let text = texts (read (page ())) in
  let has part = Alcotest.(check bool) part true (contains part text) in
  List.iter has
    [
      "Choose 4 samples a pixel";
      "An error of 1/255 takes";
      "depth 3";
      "saves 14\u{a0}%";
      "paid for nothing";
      "showcase.scene:23:3";
      "17 wrong pixels";
      "error ≈";
    ]

let pictures () =
  let sources =
    List.filter_map
      (fun (key, v) -> if key = "src" then Some v else None)
      (attributes (read (page ())))
  in
  (* The finest, the scale, five rungs with their errors, two maps and theirs. *)
  Alcotest.(check int) "pictures" (1 + 1 + 10 + 4) (List.length sources)

(* {1 What it needs} *)

let alone () =
  let events = read (page ()) in
  let fine (key, v) =
    match key with
    | "src" -> String.starts_with ~prefix:"data:image/png;base64," v
    | "href" | "srcset" | "onload" | "xmlns" -> false
    | _ -> not (contains "http" v)
  in
  let bad = List.filter (fun a -> not (fine a)) (attributes events) in
  Alcotest.(check (list (pair string string))) "links" [] bad;
  let without part =
    Alcotest.(check bool) ("no " ^ part) false (contains part (texts events))
  in
  List.iter without [ "http"; "url("; "@import"; "//" ];
  let script = function
    | Html_reader.Open { name; _ } ->
        List.mem name [ "script"; "link"; "iframe" ]
    | Close _ | Text _ -> false
  in
  Alcotest.(check bool) "no script" false (List.exists script events)

let style () =
  let escaped c = String.contains Style.css c in
  Alcotest.(check bool)
    "plain" false
    (List.exists escaped [ '<'; '>'; '&'; '"' ])

(* {1 What nothing breaks} *)

let empty () =
  let p = Lazy.force Showcase.price in
  let point = Plane.init ~width:1 ~height:1 (fun _ -> 0.) in
  let text =
    texts
      (read
         (Page.html
            {
              p with
              ladder = [];
              knee = None;
              others = [];
              law = None;
              predictions = [];
              views = [];
              time = point;
              samples = point;
            }))
  in
  let has part = Alcotest.(check bool) part true (contains part text) in
  List.iter has [ "Nothing was measured"; "all that takes time shows" ]

let escaped () =
  let p = Lazy.force Showcase.price in
  let name = "<img src=x onerror=\"&\">.scene" in
  let events = read (Page.html { p with scene = name }) in
  Alcotest.(check bool) "the name" true (contains name (texts events))

let numeric (key, v) =
  (* Pictures may spell anything. *)
  let v = String.lowercase_ascii v in
  key = "src" || not (contains "nan" v || contains "inf" v)

let survives p =
  match Html_reader.read (Page.html p) with
  | Error why -> Law.fail "%s" why
  | Ok events -> (
      let visible = String.lowercase_ascii (texts events) in
      if contains "nan" visible then Law.fail "nan is to be read"
      else
        match List.filter (fun a -> not (numeric a)) (attributes events) with
        | [] -> true
        | (key, v) :: _ -> Law.fail "%s=%S" key v)

let suite =
  ( "pages",
    [
      Law.example "a page says what its prices are" says;
      Law.example "and shows every rung and its errors" pictures;
      Law.example "it needs no script and nothing from elsewhere" alone;
      Law.example "the style holds nothing that HTML escapes" style;
      Law.example "nothing measured is a page too" empty;
      Law.example "names are text" escaped;
      Law.law ~count:300
        ~print:(fun p -> Page.html p)
        "no number, name or lack breaks a page" Hostile.price survives;
    ] )

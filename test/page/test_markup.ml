open Candor_cost
open Candor_oracle
open QCheck2

let escapes () =
  let is expected m =
    Alcotest.(check string) expected expected (Markup.to_string m)
  in
  is "a &lt;b&gt; &amp; &quot;c&quot;" (Markup.text "a <b> & \"c\"");
  is "<p class=\"&quot;&gt;\">é</p>"
    (Markup.element "p" [ ("class", "\">") ] [ Markup.text "é" ]);
  is "<img alt=\"\">" (Markup.void "img" [ ("alt", "") ]);
  is "\u{fffd}\u{fffd}x" (Markup.text "\000\255x")

let document s =
  let inner = Markup.element "b" [ ("title", s) ] [ Markup.text s ] in
  Markup.document (Markup.element "p" [] [ inner ])

let comes_back s =
  match Html_reader.read (document s) with
  | Ok
      [
        Open _;
        Open { attributes = [ (_, value) ]; _ };
        Text text;
        Close _;
        Close _;
        Text "\n";
      ] ->
      value = s && text = s
  | Ok _ -> false
  | Error why -> Law.fail "%s" why

let printable = Gen.(string_size ~gen:(char_range ' ' '~') (int_range 1 30))
let bytes = Gen.(string_size ~gen:char (int_range 0 30))

let suite =
  ( "markup",
    [
      Law.example "text and values are escaped" escapes;
      Law.law ~print:Print.string "what is written is read" printable comes_back;
      Law.law ~print:Print.string "any bytes leave a page well formed" bytes
        (fun s ->
          let page = document s in
          Result.is_ok (Html_reader.read page) && String.is_valid_utf_8 page);
    ] )

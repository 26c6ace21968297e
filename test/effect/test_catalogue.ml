open Candor_effect
open Candor_oracle

let distinct names =
  List.length (List.sort_uniq String.compare names) = List.length names

let names () =
  Alcotest.(check (list string))
    "names, in the order of the sum"
    [
      "emission";
      "ambient";
      "direct light";
      "shadows";
      "soft shadows";
      "sky light";
      "mirror";
      "refraction";
      "dispersion";
      "absorption";
      "subsurface";
      "gloss";
      "indirect light";
      "fog";
      "depth of field";
      "motion blur";
      "textures";
      "smooth normals";
      "anti-aliasing";
    ]
    (List.map Effect.name Effect.all);
  Alcotest.(check bool)
    "meanings differ" true
    (distinct (List.map Effect.meaning Effect.all));
  List.iter
    (fun e ->
      Alcotest.(check bool)
        "one line" false
        (String.contains (Effect.meaning e) '\n'))
    Effect.all

let rays () =
  let counters = List.filter_map Effect.rays Effect.all in
  Alcotest.(check (list string))
    "of these"
    [ "shadow"; "emitter"; "sky"; "mirror"; "refraction"; "bounce" ]
    (List.map Tally.name counters)

let suite =
  ( "effects",
    [
      Law.example "every effect has a name and a line of its own" names;
      Law.example "the rays that only an effect traces have a counter" rays;
    ] )

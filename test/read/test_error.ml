open Candor_read
open Candor_scene
open Text

let error line : Error.t =
  {
    place = { Place.file = "desk.scene"; line; column = 11 };
    message = "unknown field `radious` in (sphere ...)";
    hint = Some "did you mean `radius`?";
    excerpt =
      Some
        {
          text = "  (sphere (radious 2) (center 0 1 0))";
          indent = 11;
          width = 7;
        };
  }

let shape () =
  Alcotest.(check string)
    "shape"
    "desk.scene:17:11: unknown field `radious` in (sphere ...); did you mean \
     `radius`?\n\
    \   17 |   (sphere (radious 2) (center 0 1 0))\n\
    \      |            ^^^^^^^\n"
    (Format.asprintf "%a" Error.pp (error 17))

let example () =
  let text = String.make 16 '\n' ^ "  (sphere (radious 2) (center 0 1 0))" in
  Alcotest.(check (list string))
    "place"
    [ "18:11 unknown field `radious` in (sphere ...)" ]
    (messages (Printf.sprintf "(scene %s\n%s)" camera text))

let many () =
  let sphere i = Printf.sprintf "(sphere (center %d 0 0) (radius 0))\n" i in
  let text = scene (String.concat "" (List.init 60 sphere)) in
  let r = report text in
  Alcotest.(check int) "shown" 50 (List.length r.errors);
  Alcotest.(check bool)
    "last lines" true
    (String.ends_with ~suffix:"and 10 more\n60 errors\n" (show r))

let suite =
  ( "error",
    [
      case "an error names its place, what was meant, and shows the line" shape;
      case "the place of a form is its parenthesis" example;
      case "fifty errors are shown and the rest counted" many;
    ] )

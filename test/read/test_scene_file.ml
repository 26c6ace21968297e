open Candor_read
open Candor_scene
open Text

let is_error ?patience path =
  match Scene_file.read ?patience path with
  | Ok _ -> Alcotest.failf "%s is fine" path
  | Error report -> show report

let check_error ?patience path expected =
  Alcotest.(check string) path expected (is_error ?patience path)

(* {1 Files of all kinds} *)

let unreadable () =
  check_error "nowhere.scene" "nowhere.scene: there is no such file\n1 error\n";
  check_error "/tmp" "/tmp: this is a folder, not a scene\n1 error\n";
  Files.with_folder (fun folder ->
      let path = Files.write folder "secret.scene" (scene "") in
      Unix.chmod path 0;
      match Unix.getuid () with
      | 0 -> ()
      | _ -> check_error path (path ^ ": you may not read this file\n1 error\n"))

let empty () =
  check_error "/dev/null"
    "/dev/null:1:1: there is nothing here: expected (scene ...)\n1 error\n"

let zeros () =
  Alcotest.(check bool)
    "/dev/zero" true
    (String.starts_with ~prefix:"/dev/zero:1:1: a scene holds no NUL bytes\n"
       (is_error "/dev/zero"))

let fifo () =
  Files.with_pipe ~text:(scene "(sphere (center 0 0 0) (radius 1))")
    (fun path ->
      match Scene_file.read path with
      | Ok s -> Alcotest.(check int) "surfaces" 1 (List.length s.surfaces)
      | Error report -> Alcotest.fail (show report))

let fifo_excerpt () =
  Files.with_pipe ~text:(Printf.sprintf "(scene %s\n  (spere))" camera)
    (fun path ->
      check_error path
        (path
       ^ ":2:3: unknown form `spere`; did you mean `sphere`?\n\
         \    2 |   (spere))\n\
         \      |    ^^^^^\n\
          1 error\n"))

let silent_fifo () =
  Files.with_folder (fun folder ->
      let path = Filename.concat folder "pipe" in
      Unix.mkfifo path 0o600;
      check_error ~patience:0.05 path
        (path ^ ": nothing came through this pipe for 0.05 s\n1 error\n"))

(* {1 Includes} *)

let includes () =
  Files.with_folder (fun folder ->
      let write = Files.write folder in
      ignore (write "ball.scene" "(sphere (center 1 0 0) (radius 1)) ; no more");
      let path =
        write "main.scene"
          (scene
             "(sphere (center 0 0 0) (radius 1)) (include \"ball.scene\") \
              (sphere (center 2 0 0) (radius 1)) (include \"ball.scene\")")
      in
      match Scene_file.read path with
      | Error report -> Alcotest.fail (show report)
      | Ok s ->
          let x (s : Scene.surface) =
            match s.shape with
            | Sphere s -> s.x
            | Box _ | Triangle _ | Quadric _ | Polygon _ | Group _ | Mesh _
            | Use _ ->
                nan
          in
          Alcotest.(check (list (float 0.)))
            "in place" [ 0.; 1.; 2.; 1. ] (List.map x s.surfaces);
          Alcotest.(check (list string))
            "places"
            [
              "main.scene:1:70";
              "ball.scene:1:1";
              "main.scene:1:128";
              "ball.scene:1:1";
            ]
            (List.map
               (fun (s : Scene.surface) ->
                 Place.to_string
                   { s.place with file = Filename.basename s.place.file })
               s.surfaces))

let includes_by_name () =
  Files.with_folder (fun folder ->
      ignore (Files.write folder "red.scene" "(material red (matte (color 1)))");
      let text =
        scene
          "(sphere (center 0 0 0) (radius 1) (material red)) (include \
           \"red.scene\")"
      in
      match
        Scene_file.of_string ~name:(Filename.concat folder "x.scene") text
      with
      | Ok s -> Alcotest.(check int) "materials" 1 (List.length s.materials)
      | Error report -> Alcotest.fail (show report))

(* Thirty files, each of which includes the next one twice. *)
let explosion () =
  Files.with_folder (fun folder ->
      for i = 0 to 29 do
        let next = Printf.sprintf "(include \"%d\")" (i + 1) in
        ignore (Files.write folder (string_of_int i) (next ^ next))
      done;
      ignore (Files.write folder "30" "");
      let path = Files.write folder "main.scene" (scene "(include \"0\")") in
      let start = Sys.time () in
      let report = is_error path in
      Alcotest.(check bool)
        report true
        (Sys.time () -. start < 20. && String.length report < 20_000))

(* {1 Hostile texts} *)

let nested n = String.make n '(' ^ String.make n ')'

let groups n =
  String.concat "" (List.init n (fun _ -> "(group ")) ^ String.make n ')'

let deep () =
  errors "lists" [ "1:70 expected a form, not a list" ] (scene (nested 100_000));
  errors "open"
    [ "1:100069 this `(` is never closed" ]
    ( scene "" |> fun s ->
      String.sub s 0 (String.length s - 1) ^ String.make 100_000 '(' );
  errors "too deep"
    [ "1:200071 lists are nested more than 200,000 deep" ]
    (scene (nested 200_100));
  let s = ok_forms (groups 100_000) in
  let text = Scene_printer.to_string s in
  Alcotest.(check bool) "printed" true (same s (ok text))

let long_line () =
  let text =
    scene (String.concat " " (List.init 50 (fun _ -> nested 100_000)))
  in
  Alcotest.(check bool) "10 MB" true (String.length text > 10_000_000);
  let start = Sys.time () in
  let report = report text in
  Alcotest.(check int) "errors" 50 (List.length report.errors + report.more);
  Alcotest.(check bool) "short" true (String.length (show report) < 20_000);
  Alcotest.(check bool) "quick" true (Sys.time () -. start < 20.)

let bytes = QCheck2.Gen.(string_size ~gen:char (int_range 0 2000))

let judged text =
  match read text with
  | Ok _ -> true
  | Error { errors; more } -> List.length errors + more > 0

let random_bytes =
  law ~count:1000 "random bytes are an error, never an exception" bytes judged

let after_scene =
  law ~count:1000 "so are random bytes within a scene" bytes (fun s ->
      judged ("(scene " ^ s))

(* [edits] in a text: each drops, doubles or changes a byte. *)
let mutate (text, edits) =
  let edit s (at, what, byte) =
    let n = String.length s in
    if n = 0 then s
    else
      let at = at mod n in
      let before = String.sub s 0 at
      and after = String.sub s (at + 1) (n - at - 1) in
      match what with
      | 0 -> before ^ after
      | 1 -> before ^ String.make 1 byte ^ String.sub s at (n - at)
      | _ -> before ^ String.make 1 byte ^ after
  in
  List.fold_left edit text edits

let gen_mutation =
  let open QCheck2.Gen in
  let byte =
    oneof
      [
        char;
        oneof
          (List.map return
             [ '('; ')'; '"'; '\\'; ' '; '#'; '|'; ';'; '.'; '-'; 'e'; '9' ]);
      ]
  in
  let edit = triple (int_range 0 100_000) (int_range 0 2) byte in
  pair
    (map Scene_printer.to_string (Draw_scene.gen Draw_scene.scene))
    (list_size (int_range 1 5) edit)

let mutations =
  law ~count:1500 "a few wrong bytes in a scene are read or told, never raised"
    ~print:mutate gen_mutation (fun m ->
      let start = Sys.time () in
      judged (mutate m) && Sys.time () -. start < 10.)

let truncations =
  law ~count:500 "a scene that breaks off is an error"
    QCheck2.Gen.(
      pair
        (map Scene_printer.to_string (Draw_scene.gen Draw_scene.scene))
        (float_range 0. 1.))
    (fun (text, part) ->
      let n = int_of_float (part *. float_of_int (String.length text - 2)) in
      Result.is_error (read (String.sub text 0 n)))

(* {1 Linear time}

   Words allocated, unlike seconds, are the same in every run. *)

let words text =
  let before = Gc.minor_words () in
  ignore (Sys.opaque_identity (read text));
  Gc.minor_words () -. before

let linear () =
  let repeat s n = scene (String.concat "\n" (List.init n (fun _ -> s))) in
  let sphere = "(sphere (center 1.5 2.5 3.5) (radius .25))" in
  let check name text =
    let ratio = words (text 8000) /. words (text 2000) in
    Alcotest.(check bool) (Printf.sprintf "%s: %g" name ratio) true (ratio < 4.5)
  in
  check "spheres" (repeat sphere);
  check "in a group" (fun n ->
      repeat (Printf.sprintf "(group %s)" (repeat sphere n)) 1);
  check "nested groups" (fun n -> scene (groups n));
  check "errors" (repeat "(spere (center 1.5 2.5 3.5) (radius .25))");
  check "unknown fields" (fun n ->
      scene (Printf.sprintf "(sphere %s)" (repeat "(radiusses 1)" n)));
  check "materials" (fun n ->
      String.concat ""
        (List.init n (Printf.sprintf "(material m%d (matte (color 1)))"))
      |> scene);
  check "unknown materials" (fun n ->
      String.concat ""
        (List.init n
           (Printf.sprintf "(sphere (center 0 0 0) (radius 1) (material m%d))"))
      |> scene);
  check "a chain of definitions" (fun n ->
      String.concat ""
        (List.init n (fun i ->
             Printf.sprintf "(define d%d (use d%d))" i ((i + 1) mod n)))
      |> scene);
  check "one long word" (fun n -> scene (String.make n 'a'));
  check "one long line" (fun n -> scene (String.make n '('));
  check "corners" (fun n ->
      scene
        (Printf.sprintf "(triangle %s)"
           (String.concat " " (List.init n (fun _ -> "(0 0 0)")))))

let suite =
  ( "scene file",
    [
      case "what cannot be read is told without a line" unreadable;
      case "an empty file is not a scene" empty;
      case "an endless file of zeros is refused at once" zeros;
      case "a scene is read from a pipe" fifo;
      case "an error in a pipe shows its line" fifo_excerpt;
      case "a pipe without a writer is given up" silent_fifo;
      case "an include stands for the forms of its file" includes;
      case "a text includes files beside its name" includes_by_name;
      case "includes cannot multiply without end" explosion;
      case "a hundred thousand nested lists are no problem" deep;
      case "neither is a line of ten million parentheses" long_line;
      random_bytes;
      after_scene;
      mutations;
      truncations;
      case "work grows in step with the size" linear;
    ] )

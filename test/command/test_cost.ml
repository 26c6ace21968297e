open Candor

let lines text = List.filter (( <> ) "") (String.split_on_char '\n' text)
let starts line prefix = String.starts_with ~prefix line

(* A list of all settings, however busy the machine is. *)
let rec complete seconds =
  let budget = Printf.sprintf "%ds" seconds in
  let r = fine [ "cost"; "s.scene"; "--budget"; budget ] in
  if contains r.err "no time was left for" && 3 * seconds < 60 then
    complete (3 * seconds)
  else (seconds, r)

let listed () =
  let seconds, r = complete 6 in
  (match lines r.out with
  | head :: first :: _ ->
      List.iter (mentions head)
        [ "setting"; "seconds"; "rays/px"; "rms (1/255)"; "99th pct" ];
      mentions first "spp 1 "
  | _ -> Alcotest.failf "too short:\n%s" r.out);
  List.iter (mentions r.out)
    [
      "spp 4";
      "naive math";
      "without point light [s.scene:8:3]";
      "without directional light [s.scene:9:3]";
      "without mirror";
      "(was 8)";
      "1/255";
    ];
  mentions r.err "s.scene: ";
  mentions r.err
    (Printf.sprintf (if seconds < 10 then "of %d.0 s" else "of %d s") seconds);
  check_entries "no file is written" [ "s.scene" ]

(* One that lights nothing: it shines from below. *)
let idle () =
  write "t.scene"
    "(scene (image (size 16 12)) (camera (orthographic (eye 0 0 5) (look-at 0 \
     0 0) (height 2)))\n\
    \ (light (point (at 0 0 9) (intensity 90)))\n\
    \ (light (point (at 0 0 -9) (intensity 90)))\n\
    \ (box (min -9 -9 -1) (max 9 9 0)))";
  let r = fine [ "cost"; "t.scene"; "--budget"; "3s" ] in
  mentions r.out "paid for nothing: point light [t.scene:3:2]";
  Alcotest.(check bool)
    "the other is not" false
    (contains r.out "paid for nothing: point light [t.scene:2:2]")

let columns () =
  let r =
    fine [ "cost"; "s.scene"; "--budget"; "2s"; "--csv"; "p.csv"; "--quiet" ]
  in
  check_text "nothing is said" "" r.err;
  (match lines (read "p.csv") with
  | head :: rows ->
      check_text "columns" "setting,spp,seconds,rays_per_pixel,rms,p99,pareto"
        head;
      if List.length rows < 3 then Alcotest.failf "only:\n%s" (read "p.csv");
      Alcotest.(check bool)
        "the first is one sample" true
        (starts (List.hd rows) "spp 1,1,");
      List.iter
        (fun row ->
          Alcotest.(check int)
            row 7
            (List.length (String.split_on_char ',' row)))
        rows
  | [] -> Alcotest.fail "empty");
  check_entries "nothing else" [ "p.csv"; "s.scene" ]

let hurried () =
  let clock = Unix.gettimeofday () in
  let r = fine [ "cost"; "s.scene"; "--budget"; "0.001"; "--size=3000x3000" ] in
  let took = Unix.gettimeofday () -. clock in
  if took > 2. then Alcotest.failf "it took %g s" took;
  mentions r.out "spp 1";
  mentions r.err "no time was left for"

let refused () =
  fails 1 "p/q.csv" [ "cost"; "s.scene"; "--csv"; "p/q.csv"; "--budget"; "1s" ];
  fails 1 "a directory" [ "cost"; "s.scene"; "--csv"; "."; "--budget"; "1s" ];
  fails 1 "none.scene" [ "cost"; "none.scene"; "--csv"; "p.csv" ];
  write "p.csv" "old";
  write "t.scene" "(scene (ball))";
  fails 1 "t.scene:1:8" [ "cost"; "t.scene"; "--csv"; "p.csv" ];
  check_text "the old file" "old" (read "p.csv");
  check_entries "nothing is left" [ "p.csv"; "s.scene"; "t.scene" ]

let rec begun pid n =
  if n > 5000 then Alcotest.failf "process %d does not begin" pid;
  if not (List.exists (fun e -> Filename.check_suffix e ".part") (entries "."))
  then (
    ignore (Unix.select [] [] [] 0.002 : _ * _ * _);
    begun pid (n + 1))

let interrupted () =
  let err = fresh () in
  let stderr = to_file err in
  let stdin = null [ O_RDONLY ] and stdout = null [ O_WRONLY ] in
  let pid =
    start ~stdin ~stdout ~stderr
      [ "cost"; "s.scene"; "--budget"; "60s"; "--csv"; "p.csv" ]
  in
  List.iter Unix.close [ stdin; stdout; stderr ];
  begun pid 0;
  Unix.kill pid Sys.sigint;
  let ended = wait pid in
  let said = read err in
  Sys.remove err;
  Alcotest.(check int) ("exit code: " ^ said) 130 ended;
  mentions said "interrupted";
  check_entries "nothing is left" [ "s.scene" ]

let suite =
  ( "cost",
    [
      with_scene "prices are listed" listed;
      with_scene "what is paid for nothing is named" idle;
      with_scene "columns for programs" columns;
      with_scene "a budget is kept, however small" hurried;
      with_scene "what cannot be written is said" refused;
      with_scene "an interrupt leaves nothing behind" interrupted;
    ] )

open Candor

let shapes =
  {|(scene
  (camera (orthographic (eye 0 0 5) (look-at 0 0 0) (height 2)))
  (sphere (center 0 0 0) (radius 1))
  (box (min 9 -1 -1) (max 11 1 1))
  (group (transform (translate 20 0 0))
    (sphere (center 0 0 0) (radius 1))
    (group (use pair (transform (scale 2)))))
  (define pair (sphere (center 5 0 0) (radius 1)) (sphere (center 10 0 0) (radius 1))))
|}

let cast ?(args = []) input = fine ~input ([ "cast"; "c.scene" ] @ args)
let lines = String.concat "\n"

let answers () =
  check_text "hits and misses"
    (lines
       [
         "hit 4 0 0 1 0 0 1 0";
         "miss";
         "hit 2 0 0 1 0 0 1 0";
         "hit 4 10 0 1 0 0 1 1";
         "hit 1 0 0 1 -0 -0 -1 0";
         "hit 4 20 0 1 0 0 1 2.0";
         "hit 3 30 0 2 0 0 1 2.1.0.0";
         "hit 3 40 0 2 0 0 1 2.1.0.1";
         "hit 8 0 0 1 0 0 1 0";
         "";
       ])
    (cast
       (lines
          [
            "0 0 5 0 0 -1";
            "5 5 5 0 0 -1";
            "0 0 5 0 0 -2";
            "10 0 5 0 0 -1";
            "0 0 0 0 0 1";
            "20 0 5 0 0 -1";
            "30 0 5 0 0 -1";
            "40 0 5 0 0 -1";
            "0 0 5 0 0 -.5";
            "";
          ]))
      .out

let limits () =
  check_text "0 < t <= tmax"
    (lines
       [
         "hit 4 0 0 1 0 0 1 0";
         "miss";
         "hit 4 0 0 1 0 0 1 0";
         "hit 4 0 0 1 0 0 1 0";
         "miss";
         "";
       ])
    (cast
       (lines
          [
            "0 0 5 0 0 -1 4";
            "0 0 5 0 0 -1 3.9999999999999996";
            "0 0 5 0 0 -1 inf";
            "0 0 5 0 0 -1 1e300";
            "0 0 5 0 0 -1 5e-324";
            "";
          ]))
      .out

let notations () =
  check_text "decimal, hexadecimal, signs, tabs, returns and blanks"
    (lines (List.init 5 (fun _ -> "hit 4 0 0 1 0 0 1 0") @ [ "" ]))
    (cast
       (lines
          [
            "0x0p0 0x0 0x1.4p2 0 0 -0x1p0";
            "\t0  0\t5 0 0 -1  ";
            "+0 -0 5.0 0e0 0 -1.\r";
            "0 0 50e-1 0 0 -1E0";
            "0 0 5 0 0 -1 0x1p2";
          ]))
      .out

let hex () =
  check_text "exactly"
    "hit 0x1.8p+1 0x0p+0 0x0p+0 0x1p+0 0x0p+0 0x0p+0 0x1p+0 0\n"
    (cast ~args:[ "--hex" ] "0 0 4 0 0 -1").out;
  (* Every number reads back as the same double, in both notations. *)
  let ray = ".1 .2 5 .01 -.03 -1.1" in
  let numbers text =
    List.filteri
      (fun i _ -> i > 0 && i < 8)
      (String.split_on_char ' ' (String.trim text))
    |> List.map float_of_string
  in
  Alcotest.(check (list (float 0.)))
    "the same numbers"
    (numbers (cast ~args:[ "--hex" ] ray).out)
    (numbers (cast ray).out)

(* From 1e9 away the textbook is off by the radius, and from 5 away it is not. *)
let naive () =
  let rays =
    lines [ "0 0 1e9 0 0 -1"; "0 0 5 0 0 -1"; "0 0 1.000030517578125 0 0 -1" ]
  in
  check_text "Candor's"
    (lines
       [
         "hit 999999999 0 0 1 0 0 1 0";
         "hit 4 0 0 1 0 0 1 0";
         "hit 3.0517578125e-05 0 0 1 0 0 1 0";
         "";
       ])
    (cast rays).out;
  check_text "the textbook's"
    (lines
       [
         "hit 1000000000 0 0 0 1 0 0 0";
         "hit 4 0 0 1 0 0 1 0";
         "hit 2.000030517578125 0 0 -1 -0 -0 1 0";
         "";
       ])
    (cast ~args:[ "--naive-math" ] rays).out

let bad_lines () =
  let input =
    [
      "0 0 5 0 0 -1";
      "0 0 5 0 0";
      "0 0 5 0 0 x";
      "0 0 5 0 0 0";
      "";
      "0 0 nan 0 0 -1";
      "0 0 inf 0 0 -1";
      "0 0 5 0 0 -1 0";
      "0 0 5 0 0 -1 -1";
      "1_0 0 5 0 0 -1";
      "0 0 5 0 0 -1 1 1";
      "0 0 5 0 0 -1 nan";
      "5 5 5 0 0 -1";
    ]
  in
  let r = run ~input:(lines input) [ "cast"; "c.scene" ] in
  code_is "exit code" 1 r;
  check_text "the rest goes on"
    (lines
       (("hit 4 0 0 1 0 0 1 0" :: List.init 11 (fun _ -> "error"))
       @ [ "miss"; "" ]))
    r.out;
  List.iteri
    (fun i _ ->
      if i > 0 && i < 12 then
        mentions r.err (Printf.sprintf "line %d: " (i + 1)))
    input;
  Alcotest.(check bool)
    "no other line" false
    (contains r.err "line 1: " || contains r.err "line 13: ");
  mentions r.err "'x' is not a number";
  mentions r.err "got 5 numbers"

let empty () =
  check_text "no ray, no answer" "" (cast "").out;
  check_text "the last line needs no end" "miss\n" (cast "5 5 5 0 0 -1").out

(* A program asks, waits for the answer, and asks again. *)
let conversation () =
  let asks, answers =
    (Unix.pipe ~cloexec:true (), Unix.pipe ~cloexec:true ())
  in
  let stderr = null [ O_WRONLY ] in
  let pid =
    start ~stdin:(fst asks) ~stdout:(snd answers) ~stderr [ "cast"; "c.scene" ]
  in
  List.iter Unix.close [ fst asks; snd answers; stderr ];
  let buffer = Bytes.create 4096 in
  let say text =
    ignore (Unix.write_substring (snd asks) text 0 (String.length text) : int)
  in
  let hear () =
    match Unix.select [ fst answers ] [] [] 20. with
    | [ _ ], _, _ ->
        Bytes.sub_string buffer 0 (Unix.read (fst answers) buffer 0 4096)
    | _ -> Alcotest.fail "no answer within 20 seconds"
  in
  for i = 1 to 20 do
    say (Printf.sprintf "0 0 %d 0 0 -1\n" (i + 1));
    check_text "an answer at once"
      (Printf.sprintf "hit %d 0 0 1 0 0 1 0\n" i)
      (hear ())
  done;
  say "0 0 5 0";
  say " 0 -1\n5 5 5 0 0 -1\n0 0";
  let rec hear_two text =
    if List.length (String.split_on_char '\n' text) < 3 then
      hear_two (text ^ hear ())
    else text
  in
  check_text "a line in two parts, two lines in one"
    "hit 4 0 0 1 0 0 1 0\nmiss\n" (hear_two "");
  say " 5 0 0 -1";
  Unix.close (snd asks);
  check_text "the end ends a line" "hit 4 0 0 1 0 0 1 0\n" (hear ());
  Unix.close (fst answers);
  Alcotest.(check int) "exit code" 0 (wait pid)

let many () =
  let ray i =
    let a = float_of_int i *. 0.37 in
    Printf.sprintf "%.17g %.17g 5 %.17g 0 -1\n"
      (sin a *. 1.5)
      (cos (a *. 1.7))
      (sin (a *. 3.) /. 10.)
  in
  let input = String.concat "" (List.init 100_000 ray) in
  let start = Unix.gettimeofday () in
  let r = cast input in
  let seconds = Unix.gettimeofday () -. start in
  let answers = String.split_on_char '\n' (String.trim r.out) in
  Alcotest.(check int) "answers" 100_000 (List.length answers);
  let hits =
    List.length (List.filter (String.starts_with ~prefix:"hit ") answers)
  in
  Alcotest.(check bool)
    "many hits and many misses" true
    (hits > 5_000 && hits < 80_000);
  if seconds > 20. then Alcotest.failf "100,000 rays took %.1f s" seconds;
  (* Hits are on the ball, and t is where they say. *)
  List.iteri
    (fun i answer ->
      if i mod 97 = 0 && String.starts_with ~prefix:"hit " answer then
        Scanf.sscanf answer "hit %f %f %f %f %f %f %f %s"
          (fun t x y z nx ny nz path ->
            Scanf.sscanf (ray i) "%f %f %f %f %f %f" (fun ox oy oz dx dy dz ->
                let near a b = Float.abs (a -. b) < 1e-12 in
                if
                  not
                    (near ((x *. x) +. (y *. y) +. (z *. z)) 1.
                    && near x (ox +. (t *. dx))
                    && near y (oy +. (t *. dy))
                    && near z (oz +. (t *. dz))
                    && near nx x && near ny y && near nz z && path = "0")
                then Alcotest.failf "ray %d: %s" i answer)))
    answers

let long_line () =
  let r =
    run
      ~input:(String.make 3_000_000 'x' ^ "\n5 5 5 0 0 -1\n")
      [ "cast"; "c.scene" ]
  in
  code_is "exit code" 1 r;
  check_text "answers" "error\nmiss\n" r.out

let test name f =
  example name (fun () ->
      write "c.scene" shapes;
      f ())

let suite =
  ( "cast",
    [
      test "answers in the units of the direction, with places" answers;
      test "tmax is the last t that counts" limits;
      test "rays may be written in many ways" notations;
      test "--hex prints the same numbers exactly" hex;
      test "--naive-math answers by the textbook" naive;
      test "bad lines are told; the rest goes on" bad_lines;
      test "input may be empty or lack its last end of line" empty;
      test "answers come line by line, without waiting for the end" conversation;
      test "100,000 rays are answered, rightly, in reasonable time" many;
      test "a line of three million letters is an error like any other"
        long_line;
    ] )

open Candor

let render args = "render" :: "s.scene" :: args

let no_scene () =
  List.iter
    (fun c -> fails 1 "none.scene" c)
    [
      [ "render"; "none.scene" ];
      [ "check"; "none.scene" ];
      [ "explain"; "none.scene" ];
      [ "cast"; "none.scene" ];
      [ "trace"; "none.scene"; "0"; "0" ];
    ];
  Sys.mkdir "d.scene" 0o777;
  fails 1 "folder" [ "render"; "d.scene" ];
  write "bad.scene"
    "(scene\n\
    \  (camera (orthographic (eye 0 0 5) (look-at 0 0 0) (height 2)))\n\
    \  (sphere (radious 1) (center 0 0 0)))\n";
  fails 1 "bad.scene:3:" [ "render"; "bad.scene" ];
  check_entries "nothing is written" [ "bad.scene"; "d.scene" ]

let bad_targets () =
  Sys.mkdir "d.ppm" 0o777;
  fails 1 "d.ppm: cannot write: it is a directory" (render [ "-o"; "d.ppm" ]);
  fails 1 "no/where.ppm: cannot write: no such file or directory"
    (render [ "-o"; "no/where.ppm" ]);
  fails 1 "not a directory" (render [ "-o"; "s.scene/x.ppm" ]);
  fails 1 "cannot write" (render [ "-o"; "/proc/candor.ppm" ]);
  fails 1 "no/t.json: cannot write"
    (render [ "-o"; "a.ppm"; "--stats"; "no/t.json" ]);
  fails 1 "d.ppm: cannot write: it is a directory"
    (render [ "-o"; "a.ppm"; "--stats"; "d.ppm" ]);
  check_entries "nothing is written" [ "d.ppm"; "s.scene" ];
  if Unix.geteuid () <> 0 then (
    write "a.ppm" "old";
    Unix.chmod "a.ppm" 0o444;
    fails 1 "permission" (render [ "-o"; "a.ppm" ]);
    check_text "as it was" "old" (read "a.ppm"))

(* Known before the first ray: an hour of rendering is not lost. *)
let at_once () =
  let start = Unix.gettimeofday () in
  fails 1 "directory"
    (render [ "-o"; "no/where.ppm"; "--size=4000x4000"; "--spp=1000" ]);
  Alcotest.(check bool) "at once" true (Unix.gettimeofday () -. start < 5.)

let full_disk () =
  write "a.ppm" "old";
  let limited more =
    shell
      ("ulimit -f 1; exec \"$CANDOR\" render s.scene --size 200x100 --spp 1 "
     ^ more)
  in
  let refused name r =
    code_is name 1 r;
    mentions r.err "a.ppm: cannot write: ";
    mentions r.err "too large";
    Alcotest.(check int)
      "one line" 1
      (List.length (String.split_on_char '\n' (String.trim r.err)));
    check_text "the old picture" "old" (read "a.ppm")
  in
  refused "a picture" (limited "-o a.ppm");
  check_entries "nothing is left" [ "a.ppm"; "s.scene" ];
  refused "with statistics" (limited "-o a.ppm --stats t.json");
  check_entries "nothing is left of them either" [ "a.ppm"; "s.scene" ];
  Unix.symlink "/dev/full" "f.ppm";
  fails 1 "no space left" (render [ "-o"; "f.ppm" ]);
  let r = shell "\"$CANDOR\" render s.scene -o - >/dev/full" in
  code_is "standard output" 1 r;
  mentions r.err "standard output: cannot write: no space left"

let closed_pipe () =
  let through reader more =
    shell (Printf.sprintf "{ \"$CANDOR\" %s; echo $? >code; } | %s" more reader)
  in
  let check name more =
    let r = through "true" more in
    let code = String.trim (read "code") in
    if
      contains r.err "Raised" || contains r.err "exception"
      || contains r.err "internal"
    then Alcotest.failf "%s: %s" name r.err;
    Alcotest.(check string) (name ^ ", exit code") "1" code;
    mentions (String.lowercase_ascii r.err) "broken pipe"
  in
  (* More than a pipe holds, so that somebody must have been reading. *)
  check "a picture" "render s.scene --size 400x300 --spp 1 -o -";
  let many = String.concat "\n" (List.init 20000 (fun _ -> "0 0 5 0 0 -1")) in
  write "rays" many;
  check "answers" "cast s.scene <rays"

let no_stdin () =
  let r = shell "\"$CANDOR\" cast s.scene <&-" in
  code_is "closed standard input" 1 r;
  if contains r.err "Raised" || contains r.err "internal" then
    Alcotest.fail r.err

let outside () =
  fails 2 "outside of the picture" [ "trace"; "s.scene"; "24"; "0" ];
  fails 2 "outside of the picture" [ "trace"; "s.scene"; "0"; "18" ];
  fails 2 "sample" [ "trace"; "s.scene"; "0"; "0"; "--sample"; "4" ];
  fails 2 "outside of the picture"
    [ "trace"; "s.scene"; "5"; "5"; "--size"; "5x5" ]

let suite =
  ( "trouble",
    [
      example "a scene that is not there or wrong ends with 1" no_scene;
      with_scene "a target that cannot be written ends with 1" bad_targets;
      with_scene "and it is known before the first ray" at_once;
      with_scene "a full disk leaves the old picture and no other file"
        full_disk;
      with_scene "a closed pipe is an error like any other" closed_pipe;
      with_scene "so is a closed standard input" no_stdin;
      with_scene "pixels and samples that are not there end with 2" outside;
    ] )

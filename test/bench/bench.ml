(* Speed and size, as tables. Compare ratios within one run: machines are
   noisy. *)

let table title f =
  Printf.printf "\n%s\n%!" title;
  f ()

let all profile scenes =
  if profile <> "release" then
    print_endline
      "Note: this is not the release profile; run dune build @bench --profile \
       release.";
  table "Speed" (fun () -> Speed.table scenes);
  table "The sphereflake beside POV-Ray" (fun () -> Pov.table scenes);
  table "Whole renders, beside the textbook's math" (fun () ->
      Naive.table scenes);
  table "What the absence of effects is worth" (fun () -> Absent.table scenes);
  table "Errors of adaptive sampling, beside uniform, in 1/255" (fun () ->
      Adaptive.table ~names:[] scenes);
  table "Size" Memory.table

let () =
  match Array.to_list Sys.argv with
  | [ _; "memory"; n ] -> Memory.child (int_of_string n)
  | [ _; "naive"; scenes ] -> Naive.table scenes
  | [ _; "absent"; scenes ] -> Absent.table scenes
  | _ :: "adaptive" :: scenes :: names -> Adaptive.table ~names scenes
  | [ _; profile; scenes ] -> all profile scenes
  | _ -> prerr_endline "usage: bench PROFILE|naive|absent|adaptive SCENES"

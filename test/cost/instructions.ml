(* How many instructions renders take, beside how many they took before. *)

let most = 1.01

let need_valgrind () =
  if not Callgrind.is_there then (
    prerr_endline
      "Instructions are counted by valgrind, which is not here. Install the \
       package valgrind and run this again.";
    exit 1)

let compare_row candor (row : Stored.row) =
  let now = Callgrind.render candor row in
  let ratio = float_of_int now /. float_of_int row.instructions in
  Printf.printf "%-16s %14d %14d %8.4f\n%!" row.scene row.instructions now ratio;
  ratio

(* Whether nothing is slower than it was in the table of that name. *)
let holds candor name =
  let table = Stored.read name in
  Printf.printf
    "Instructions of renders less one pixel's, as callgrind counts them\n\
     %s by: %s\n\
     now by: %s, %s profile\n\n\
     %-16s %14s %14s %8s\n\
     %!"
    name table.compiler Built.compiler Built.profile "scene" name "now" "ratio";
  let ratios = List.map (compare_row candor) (Stored.measured table) in
  print_newline ();
  if Stored.same_compiler table && Built.profile = "release" then
    List.for_all (fun r -> r <= most) ratios
  else (
    print_endline
      "Another compiler or profile than the table's: nothing is asked of the \
       ratios.";
    true)

let compare candor names =
  let held = List.map (holds candor) names in
  if not (List.for_all Fun.id held) then (
    Printf.printf
      "A ratio is above %g: what was added slows scenes without it.\n" most;
    exit 1)

let measure candor name =
  if Built.profile <> "release" then (
    prerr_endline "The table holds for --profile release only.";
    exit 1);
  let row r = { (Now.row r) with instructions = Callgrind.render candor r } in
  let table = Stored.read name in
  Stored.print
    { table with compiler = Built.compiler; rows = List.map row table.rows }

let () =
  need_valgrind ();
  match Array.to_list Sys.argv with
  | _ :: "compare" :: candor :: names -> compare candor names
  | [ _; "measure"; candor; name ] -> measure candor name
  | _ ->
      prerr_endline "usage: instructions compare|measure CANDOR TABLE";
      exit 2

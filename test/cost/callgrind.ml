(* Instructions, counted by valgrind's callgrind. *)

let is_there = Sys.command "valgrind --version >/dev/null 2>&1" = 0

(* Callgrind closes with "==1234== Collected : 56789" on stderr. *)
let collected line =
  Scanf.sscanf_opt line "==%d== Collected : %d" (fun _ n -> n)

let output command =
  let channel = Unix.open_process_in command in
  let lines = In_channel.input_lines channel in
  ignore (Unix.close_process_in channel : Unix.process_status);
  lines

(* So little marking that the size of a scene's data does not show. *)
let collector = "OCAMLRUNPARAM=o=100000 "

let instructions arguments =
  let command =
    collector
    ^ Filename.quote_command "valgrind"
        ("--tool=callgrind" :: "--callgrind-out-file=/dev/null" :: arguments)
  in
  let lines = output (command ^ " 2>&1") in
  match List.find_map collected lines with
  | Some n -> n
  | None ->
      List.iter prerr_endline lines;
      prerr_endline ("callgrind counted nothing in: " ^ command);
      exit 1

(** [render candor row] is the number of instructions by which rendering [row]
    exceeds rendering one pixel of it, so that start, reading and set-up cancel.
    It repeats to a millionth of itself. *)
let render candor (row : Stored.row) =
  let picture = Filename.temp_file "candor" ".pfm" in
  let size = Printf.sprintf "%dx%d" row.width row.height in
  let spp = string_of_int row.spp in
  let count crop =
    instructions
      ([ candor; "render"; Now.path row.scene; "--quiet"; "-j"; "1" ]
      @ [ "--size"; size; "--spp"; spp; "-o"; picture ]
      @ crop)
  in
  let n = count [] - count [ "--crop"; "0,0,1,1" ] in
  Sys.remove picture;
  n

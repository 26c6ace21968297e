(* Tables of what renders cost when they were measured. *)

type row = {
  scene : string;
  width : int;
  height : int;
  spp : int;
  digest : string;  (** MD5 of the picture as PFM *)
  words : int;  (** allocated while tracing, in the release profile *)
  instructions : int;
  counts : (string * int) list;  (** of the tally, those that are not 0 *)
}

type t = {
  remarks : string list;
  compiler : string;  (** which words and instructions depend on *)
  rows : row list;
}

(* What is not measured yet. *)
let none = "-"
let count_of_string s = Scanf.sscanf s "%[^=]=%d" (fun name n -> (name, n))
let count_to_string (name, n) = Printf.sprintf "%s=%d" name n

let counts_of_string s =
  if s = none then [] else List.map count_of_string (String.split_on_char ',' s)

let counts_to_string = function
  | [] -> none
  | counts -> String.concat "," (List.map count_to_string counts)

let row_of_string line =
  Scanf.sscanf line "%s %dx%d %d %s %d %d %s@\n"
    (fun scene width height spp digest words instructions counts ->
      let counts = counts_of_string counts in
      { scene; width; height; spp; digest; words; instructions; counts })

let row_to_string r =
  Printf.sprintf "%-16s %9s %3d %32s %10d %12d %s" r.scene
    (Printf.sprintf "%dx%d" r.width r.height)
    r.spp r.digest r.words r.instructions
    (counts_to_string r.counts)

let is_remark line = line = "" || line.[0] = ';'

let read name =
  let file = Filename.(concat (dirname Sys.executable_name) (name ^ ".txt")) in
  let lines = In_channel.with_open_bin file In_channel.input_lines in
  match List.partition is_remark lines with
  | remarks, compiler :: rows ->
      { remarks; compiler; rows = List.map row_of_string rows }
  | remarks, [] -> { remarks; compiler = "unknown"; rows = [] }

let print t =
  List.iter print_endline t.remarks;
  print_endline t.compiler;
  List.iter (fun r -> print_endline (row_to_string r)) t.rows

(** [measured t] leaves out rows without figures. *)
let measured t = List.filter (fun r -> r.digest <> none) t.rows

(** [same_compiler t] says whether words and instructions can be compared. *)
let same_compiler t = t.compiler = Built.compiler

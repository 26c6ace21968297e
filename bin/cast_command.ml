open Cmdliner
open Candor_space
open Candor_surface

(* {1 Reading rays} *)

let number s =
  if String.contains s '_' then None
  else
    match float_of_string_opt s with
    | Some x when not (Float.is_nan x) -> Some x
    | Some _ | None -> None

let words line =
  String.map (fun c -> if c = '\t' || c = '\r' then ' ' else c) line
  |> String.split_on_char ' '
  |> List.filter (fun w -> w <> "")

let rec numbers = function
  | [] -> Ok []
  | w :: rest -> (
      match number w with
      | None -> Error (Printf.sprintf "'%s' is not a number" w)
      | Some x -> Result.map (fun xs -> x :: xs) (numbers rest))

let ray line =
  match numbers (words line) with
  | Error _ as e -> e
  | Ok (ox :: oy :: oz :: dx :: dy :: dz :: (([] | [ _ ]) as tmax)) ->
      let limit = match tmax with [] -> infinity | t :: _ -> t in
      let o = Point.v ox oy oz and d = Vec.v dx dy dz in
      if not (Point.is_finite o && Vec.is_finite d) then
        Error "origin and direction must be finite"
      else if Vec.largest d = 0. then Error "the direction is zero"
      else if not (limit > 0.) then Error "tmax must be above 0"
      else Ok (Ray.v o d, limit)
  | Ok xs ->
      Error
        (Printf.sprintf "expected ox oy oz dx dy dz [tmax], got %d numbers"
           (List.length xs))

(* {1 Printing hits} *)

let decimal x =
  let short = Printf.sprintf "%.15g" x in
  if Float.equal (float_of_string short) x then short
  else Printf.sprintf "%.17g" x

let hex x = Printf.sprintf "%h" x

let answer number surface (ray, limit) =
  match Surface.nearest surface ~limit ray with
  | None -> "miss"
  | Some (h : Candor_optics.Skin.t Hit.t) ->
      let p = h.point and n = (h.normal :> Vec.t) in
      let path = List.map string_of_int h.path in
      String.concat " "
        (("hit" :: List.map number [ h.t; p.x; p.y; p.z; n.x; n.y; n.z ])
        @ [ String.concat "." path ])

(* {1 Lines}

   Input is taken as it comes and answered at once, so that a program may talk
   with this one through pipes. *)

type progress = { line : int; bad : bool; rest : string }

let answer_line reply p line =
  let n = p.line + 1 in
  match ray line with
  | Ok r ->
      print_string (reply r);
      print_char '\n';
      { p with line = n }
  | Error why ->
      print_string "error\n";
      Status.tell (Printf.sprintf "candor: line %d: %s" n why);
      { p with line = n; bad = true }

let answer_chunk reply p chunk =
  match List.rev (String.split_on_char '\n' (p.rest ^ chunk)) with
  | [] -> p
  | rest :: lines ->
      let p = List.fold_left (answer_line reply) p (List.rev lines) in
      { p with rest }

let rec converse reply buffer p =
  match Unix.read Unix.stdin buffer 0 (Bytes.length buffer) with
  | 0 -> if p.rest = "" then p else answer_line reply p p.rest
  | n ->
      let p = answer_chunk reply p (Bytes.sub_string buffer 0 n) in
      flush stdout;
      converse reply buffer p
  | exception Unix.Unix_error (EINTR, _, _) -> converse reply buffer p

let run file math as_hex =
  match Settings.read file with
  | Error status -> status
  | Ok scene ->
      let reply =
        answer
          (if as_hex then hex else decimal)
          (Candor_optics.Skin.surface ~math scene)
      in
      let p =
        converse reply (Bytes.create 65536) { line = 0; bad = false; rest = "" }
      in
      if p.bad then Reported else Fine

let as_hex =
  Arg.(
    value & flag
    & info [ "hex" ] ~doc:"Print numbers as hexadecimal floats, exactly.")

let man =
  [
    `S Manpage.s_description;
    `P
      "Intersects rays with a scene. Each line of standard input is a ray, \
       $(b,ox oy oz dx dy dz [tmax]), in decimal or hexadecimal; hits count at \
       0 < t <= tmax. Each line of output answers one: $(b,miss), or $(b,hit t \
       px py pz nx ny nz PATH). t is in units of the direction as given; the \
       normal is the unit geometric one that faces the ray's origin; PATH is \
       the surface's place in the scene, such as 3 or 2.0.7, counting from 0.";
    `P
      "A bad line is answered $(b,error) and reported with its number; the \
       rest go on, and the exit code is 1.";
    `S Manpage.s_examples;
    `Pre "  echo '0 0 5 0 0 -1' | candor cast scenes/one-sphere.scene";
  ]

let command =
  Cmd.v
    (Cmd.info "cast" ~doc:"intersect rays from standard input with a scene" ~man
       ~exits:Status.infos)
    Term.(const run $ Settings.scene $ Settings.math $ as_hex)

open Candor_space
open Candor_surface

(* Where the numbers are read. *)
type body = {
  text : Mesh_text.t;
  bytes : string;
  form : Ply_header.form;
  mutable element : string;
  mutable row : int;
}

let refuse b why =
  match b.form with
  | Ascii -> Mesh_text.refuse b.text why
  | Binary _ ->
      let place = Printf.sprintf "%s %d: " b.element b.row in
      raise_notrace (Mesh_text.Refused (place ^ why))

(* {1 Numbers} *)

let in_text b =
  match Number.of_string (Mesh_text.need b.text "a number") with
  | Ok x -> x
  | Error why -> refuse b why

let unsigned x = float_of_int (Int32.to_int x land 0xffffffff)

let in_bytes b ~big (number : Ply_header.number) =
  let size = Ply_header.bytes number in
  if Mesh_text.left b.text < size then refuse b "the file ends early";
  let at = Mesh_text.take b.text size and s = b.bytes in
  let int32 = if big then String.get_int32_be else String.get_int32_le
  and int64 = if big then String.get_int64_be else String.get_int64_le in
  match number with
  | Int8 -> float_of_int (String.get_int8 s at)
  | Uint8 -> float_of_int (String.get_uint8 s at)
  | Int16 ->
      float_of_int
        (if big then String.get_int16_be s at else String.get_int16_le s at)
  | Uint16 ->
      float_of_int
        (if big then String.get_uint16_be s at else String.get_uint16_le s at)
  | Int32 -> Int32.to_float (int32 s at)
  | Uint32 -> unsigned (int32 s at)
  | Float32 -> Int32.float_of_bits (int32 s at)
  | Float64 -> Int64.float_of_bits (int64 s at)

let number b kind =
  match b.form with
  | Ascii -> in_text b
  | Binary { big_endian } -> in_bytes b ~big:big_endian kind

let whole b kind =
  let x = number b kind in
  if Float.is_integer x && Float.abs x < 0x1p32 then int_of_float x
  else refuse b (Printf.sprintf "%s is not a whole number" (Number.to_string x))

(* Every item takes a byte or more, so that no length asks for more memory than
   there is file. *)
let length b kind =
  let n = whole b kind in
  if n < 0 then refuse b "a list cannot have a negative length"
  else if n > Mesh_text.left b.text then refuse b "the file ends early"
  else n

(* {1 Rows} *)

let skip b : Ply_header.property -> unit = function
  | Scalar (_, kind) -> ignore (number b kind : float)
  | List (_, count, item) ->
      for _ = 1 to length b count do
        ignore (number b item : float)
      done

(* A row of text is a line that is not blank. *)
let rec seek_row b =
  if Mesh_text.is_over b.text then refuse b "the file ends early"
  else if Mesh_text.is_blank_line b.text then (
    Mesh_text.next_line b.text;
    seek_row b)

let end_row b =
  match Mesh_text.word b.text with
  | "" -> Mesh_text.next_line b.text
  | _ -> refuse b "more numbers than the properties of this row"

let rows b (e : Ply_header.element) read =
  b.element <- e.name;
  if Array.length e.properties > 0 then
    for row = 0 to e.count - 1 do
      b.row <- row;
      match b.form with
      | Ascii ->
          seek_row b;
          read ();
          end_row b
      | Binary _ -> read ()
    done

let skip_rows b (e : Ply_header.element) =
  rows b e (fun () -> Array.iter (skip b) e.properties)

(* {1 Vertices} *)

type columns = {
  x : int;
  y : int;
  z : int;
  normal : (int * int * int) option;
  uv : (int * int) option;
}

let column (e : Ply_header.element) name =
  let named : Ply_header.property -> bool = function
    | Scalar (name', _) -> String.equal name name'
    | List _ -> false
  in
  Array.find_index named e.properties

let columns b (e : Ply_header.element) =
  let find = column e in
  let pair u v =
    match (find u, find v) with
    | Some u, Some v -> Some (u, v)
    | None, _ | _, None -> None
  in
  let normal =
    match (find "nx", find "ny", find "nz") with
    | Some x, Some y, Some z -> Some (x, y, z)
    | None, _, _ | _, None, _ | _, _, None -> None
  and uv =
    match pair "u" "v" with Some _ as found -> found | None -> pair "s" "t"
  in
  match (find "x", find "y", find "z") with
  | Some x, Some y, Some z -> { x; y; z; normal; uv }
  | None, _, _ | _, None, _ | _, _, None ->
      refuse b "a vertex needs the properties x, y and z"

let corner b columns row =
  let at i =
    let x = Float.Array.get row i in
    if Reach.length x then x else refuse b Reach.message
  in
  let normal = Option.map (fun (x, y, z) -> Vec.v (at x) (at y) (at z))
  and uv = Option.map (fun (u, v) -> (at u, at v)) in
  Faces.corner
    (Point.v (at columns.x) (at columns.y) (at columns.z))
    ?uv:(uv columns.uv) ?normal:(normal columns.normal)

let add_vertices b corners (e : Ply_header.element) =
  let columns = columns b e in
  let row = Float.Array.make (Array.length e.properties) 0. in
  let read i : Ply_header.property -> unit = function
    | Scalar (_, kind) -> Float.Array.set row i (number b kind)
    | List _ as list -> skip b list
  in
  rows b e (fun () ->
      Array.iteri read e.properties;
      Dynarray.add_last corners (corner b columns row))

(* {1 Faces} *)

let names_corners name =
  String.equal name "vertex_indices" || String.equal name "vertex_index"

let check_list b (e : Ply_header.element) =
  let is_list : Ply_header.property -> bool = function
    | List (name, _, item) -> names_corners name && Ply_header.is_whole item
    | Scalar _ -> false
  in
  if not (Array.exists is_list e.properties) then
    refuse b "a face needs a list of whole numbers called vertex_indices"

let add_faces b corners faces (e : Ply_header.element) =
  check_list b e;
  let corner item =
    let i = whole b item and count = Dynarray.length corners in
    if i >= 0 && i < count then Dynarray.get corners i
    else refuse b (Printf.sprintf "there is no vertex %d: %d are above" i count)
  in
  let face count item =
    let n = length b count in
    if n < 3 then
      refuse b (Printf.sprintf "a face needs three corners or more, not %d" n);
    Faces.add faces (Array.init n (fun _ -> corner item))
  in
  let read : Ply_header.property -> unit = function
    | List (name, count, item) when names_corners name -> face count item
    | (List _ | Scalar _) as other -> skip b other
  in
  rows b e (fun () -> Array.iter read e.properties)

(* {1 The whole} *)

let faces bytes text =
  let { Ply_header.form; elements } = Ply_header.read text in
  let b = { text; bytes; form; element = "row"; row = 0 } in
  let corners = Dynarray.create () and faces = Faces.start () in
  let add (e : Ply_header.element) =
    match e.name with
    | "vertex" -> add_vertices b corners e
    | "face" -> add_faces b corners faces e
    | _ -> skip_rows b e
  in
  List.iter add elements;
  faces

let read text = Result.bind (Mesh_text.reading (faces text) text) Faces.finish

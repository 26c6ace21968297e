open Candor_space

type mesh = {
  points : Point.t Dynarray.t;
  uvs : (float * float) Dynarray.t;
  normals : Vec.t Dynarray.t;
  faces : Faces.building;
}

let triple text =
  let x = Mesh_text.length text "x" in
  let y = Mesh_text.length text "y" in
  let z = Mesh_text.length text "z" in
  (x, y, z)

let point text =
  let x, y, z = triple text in
  Point.v x y z

let normal text =
  let x, y, z = triple text in
  Vec.v x y z

let is_comment word = String.starts_with ~prefix:"#" word

let uv text =
  let u = Mesh_text.length text "u" in
  match Mesh_text.word text with
  | "" -> (u, 0.)
  | word when is_comment word -> (u, 0.)
  | word -> (
      match Number.of_string word with
      | Ok v when Candor_surface.Reach.length v -> (u, v)
      | Ok _ -> Mesh_text.refuse text Candor_surface.Reach.message
      | Error why -> Mesh_text.refuse text why)

let is_digit = function '0' .. '9' | '-' | '+' -> true | _ -> false

let whole text word =
  match int_of_string_opt word with
  | Some n when String.for_all is_digit word -> n
  | Some _ | None ->
      Mesh_text.refuse text
        (Printf.sprintf "%s is not the number of a corner" (Quote.word word))

let find text what known word =
  let n = whole text word in
  let count = Dynarray.length known in
  let i = if n < 0 then count + n else n - 1 in
  if i >= 0 && i < count then Dynarray.get known i
  else
    Mesh_text.refuse text
      (Printf.sprintf "there is no %s %d: %d are above" what n count)

let corner m text word =
  let find what known = function
    | "" -> None
    | word -> Some (find text what known word)
  in
  let corner v vt vn =
    match find "v" m.points v with
    | Some p ->
        Faces.corner p ?uv:(find "vt" m.uvs vt) ?normal:(find "vn" m.normals vn)
    | None ->
        Mesh_text.refuse text (Quote.word word ^ " has no number of a vertex")
  in
  match String.split_on_char '/' word with
  | [ v ] -> corner v "" ""
  | [ v; vt ] -> corner v vt ""
  | [ v; vt; vn ] -> corner v vt vn
  | [] | _ :: _ :: _ :: _ :: _ ->
      Mesh_text.refuse text
        (Printf.sprintf "expected v/vt/vn, not %s" (Quote.word word))

let face m text =
  let rec corners found =
    match Mesh_text.word text with
    | "" -> List.rev found
    | word when is_comment word -> List.rev found
    | word -> corners (corner m text word :: found)
  in
  let corners = Array.of_list (corners []) in
  let n = Array.length corners in
  if n >= 3 then Faces.add m.faces corners
  else
    Mesh_text.refuse text
      (Printf.sprintf "a face needs three corners or more, not %d" n)

let statement m text =
  match Mesh_text.word text with
  | "v" -> Dynarray.add_last m.points (point text)
  | "vt" -> Dynarray.add_last m.uvs (uv text)
  | "vn" -> Dynarray.add_last m.normals (normal text)
  | "f" -> face m text
  | _ -> ()

let faces text =
  let m =
    {
      points = Dynarray.create ();
      uvs = Dynarray.create ();
      normals = Dynarray.create ();
      faces = Faces.start ();
    }
  in
  while not (Mesh_text.is_over text) do
    statement m text;
    Mesh_text.next_line text
  done;
  m.faces

let read text = Result.bind (Mesh_text.reading faces text) Faces.finish

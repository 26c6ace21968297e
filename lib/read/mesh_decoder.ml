open Candor_scene

let ( let* ) = Result.bind

let format path =
  match Filename.extension path with
  | "" ->
      Error
        (Printf.sprintf "%S has no extension: expected .obj or .ply"
           (Filename.basename path))
  | extension -> (
      match String.lowercase_ascii extension with
      | ".obj" -> Ok Obj.read
      | ".ply" -> Ok Ply.read
      | _ ->
          Error
            (Printf.sprintf "unknown extension %S: expected .obj or .ply"
               extension))

let load path =
  let* read = format path in
  let* text = Contents.of_file ~what:"a mesh" path in
  read text

let found notes file span =
  let path = Notes.beside notes file in
  match Notes.mesh notes path (fun () -> load path) with
  | Ok { Faces.triangles; dropped } ->
      Some (Scene.Mesh { file; triangles; dropped })
  | Error why ->
      Notes.refuse notes span (Printf.sprintf "%s: %s" (Quote.word path) why)

let mesh attributes =
  let arguments = "FILE " ^ Decode.arguments attributes in
  let read_body notes (form : Form.t) =
    match form.body with
    | { node = Atom file; span } :: body -> (
        let shape = found notes file span in
        let attributes = Decode.read_body attributes notes { form with body } in
        match (attributes, shape) with
        | Some dress, Some shape -> Some (dress shape)
        | None, _ | _, None -> None)
    | [] | { node = List _; _ } :: _ ->
        Notes.refuse notes form.span
          (Printf.sprintf "expected a file: %s"
             (Form.synopsis form.head arguments))
  in
  Decode.body arguments read_body

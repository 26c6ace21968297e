open Candor_colour
open Candor_scene
open Decode
open Fields

let rgb rule =
  Quantity.numbers "R G B" rule |> map (fun a -> Rgb.v a.(0) a.(1) a.(2))

let grey rule =
  Quantity.number rule ~hint:"write a number for grey, or (rgb R G B)"
    (fun () -> "a colour")
  |> map_value Rgb.grey

let light_or what cases f =
  let rule = Rule.not_negative in
  choice what
    ~atom:(map_value f (grey rule))
    (("rgb", map f (rgb rule)) :: cases)
  |> one "COLOUR"

let light = light_or "colour" [] Fun.id
let share = Rule.within 0. 1.

let reflectance =
  choice "colour" ~atom:(grey share) [ ("rgb", rgb share) ] |> one "COLOUR"

let constant c = Texture.Constant c

let two_needed colours =
  Error (Printf.sprintf "two colours are needed, not %d" (List.length colours))

let checker texture =
  let+ colours = items texture
  and+ scale = default "scale" (Geometry_decoder.size "S") 1. in
  match colours with
  | [ even; odd ] -> Ok (Texture.Checker { even; odd; scale })
  | [] | [ _ ] | _ :: _ :: _ :: _ -> two_needed colours

let noise texture =
  let+ colours = items texture
  and+ scale = default "scale" (Geometry_decoder.size "S") 1.
  and+ octaves = default "octaves" (Quantity.whole "N" ~min:1 ~max:64) 1 in
  match colours with
  | [ first; second ] -> Ok (Texture.Noise { first; second; scale; octaves })
  | [] | [ _ ] | _ :: _ :: _ :: _ -> two_needed colours

let picture use load =
  body "FILE" (fun notes form ->
      let file (file, span) =
        let path = Notes.beside notes file in
        match Notes.picture notes (use ^ path) (fun () -> load path) with
        | Ok texels -> Some (file, texels)
        | Error why ->
            Notes.refuse notes span
              (Printf.sprintf "%s: %s" (Quote.word path) why)
      in
      Option.bind (read_body (one "FILE" name) notes form) file)

let radiance = picture "radiance " Picture_decoder.load

let image =
  picture "reflectance " Picture_decoder.load_reflectance
  |> map (fun (file, texels) -> Texture.Image { file; texels })

let texture =
  fix (fun texture ->
      choice "colour"
        ~atom:(map_value constant (grey share))
        [
          ("rgb", map constant (rgb share));
          ("checker", fields (checker texture) |> check Fun.id);
          ("noise", fields (noise texture) |> check Fun.id);
          ("image", image);
        ])
  |> one "COLOUR"

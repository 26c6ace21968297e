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

let light_or what ?later cases f =
  let rule = Rule.not_negative in
  choice what
    ~atom:(map_value f (grey rule))
    ?later
    (("rgb", map f (rgb rule)) :: cases)
  |> one "COLOUR"

let light = light_or "colour" [] Fun.id
let share = Rule.within 0. 1.

let reflectance =
  choice "colour" ~atom:(grey share) [ ("rgb", rgb share) ] |> one "COLOUR"

let constant c = Texture.Constant c

let checker texture =
  let+ colours = items texture
  and+ scale = default "scale" (Geometry_decoder.size "S") 1. in
  match colours with
  | [ even; odd ] -> Ok (Texture.Checker { even; odd; scale })
  | [] | [ _ ] | _ :: _ :: _ :: _ ->
      Error
        (Printf.sprintf "two colours are needed, not %d" (List.length colours))

let texture =
  fix (fun texture ->
      choice "colour"
        ~atom:(map_value constant (grey share))
        ~later:[ "noise"; "image" ]
        [
          ("rgb", map constant (rgb share));
          ("checker", fields (checker texture) |> check Fun.id);
        ])
  |> one "COLOUR"

open Candor_colour
open Candor_read
open Candor_scene
open Text

let light = Piece.reads Rgb.equal Colour_decoder.light
let no_light = Piece.refuses Colour_decoder.light
let reflectance = Piece.reads Rgb.equal Colour_decoder.reflectance
let no_reflectance = Piece.refuses Colour_decoder.reflectance
let texture = Piece.reads Texture.equal Colour_decoder.texture
let no_texture = Piece.refuses Colour_decoder.texture
let grey k = Texture.Constant (Rgb.grey k)

let lights () =
  light "(c 0)" Rgb.black;
  light "(c 2.5)" (Rgb.grey 2.5);
  light "(c 1e300)" (Rgb.grey 1e300);
  light "(c (rgb 0 1 200))" (Rgb.v 0. 1. 200.);
  light "(c (rgb -0 0 0))" Rgb.black

let no_lights () =
  no_light "(c -1)" [ "4 a colour must not be negative, but is `-1`" ];
  no_light "(c (rgb 1 -2 -3))"
    [
      "11 G of (rgb ...) must not be negative, but is `-2`";
      "14 B of (rgb ...) must not be negative, but is `-3`";
    ];
  no_light "(c red)"
    [ "4 `red` is not a number; write a number for grey, or (rgb R G B)" ];
  no_light "(c (rgb 1 2))" [ "4 expected (rgb R G B), found 2 words" ];
  no_light "(c (hsv 1 2 3))" [ "4 unknown colour `hsv`; expected rgb" ];
  no_light "(c)" [ "1 expected (c COLOUR), found nothing" ];
  no_light "(c 1 2 3)" [ "1 expected (c COLOUR), found 3 words" ]

let any_light =
  law ~count:1000 "a light is any colour without a negative part, to the bit"
    ~print:QCheck2.Print.(triple float float float)
    QCheck2.Gen.(triple Piece.number Piece.number Piece.number)
    (fun (r, g, b) ->
      let is_light = List.for_all (fun x -> x >= 0.) [ r; g; b ] in
      let rgb = Printf.sprintf "(c (rgb %h %h %h))" r g b in
      match Piece.body Colour_decoder.light rgb with
      | Some c, [] ->
          is_light
          && List.for_all2 Piece.same_bits [ r; g; b ] [ c.r; c.g; c.b ]
      | None, _ :: _ -> not is_light
      | Some _, _ :: _ | None, [] -> false)

let shares () =
  reflectance "(c 0)" Rgb.black;
  reflectance "(c 1)" Rgb.white;
  reflectance "(c (rgb 0 .5 1))" (Rgb.v 0. 0.5 1.);
  no_reflectance "(c 0x1.0000000000001p0)"
    [ "4 a colour must be from 0 to 1, but is `0x1.0000000000001p0`" ];
  no_reflectance "(c -0x1p-1074)"
    [ "4 a colour must be from 0 to 1, but is `-0x1p-1074`" ];
  no_reflectance "(c (rgb 0 2 1))"
    [ "11 G of (rgb ...) must be from 0 to 1, but is `2`" ]

let cases () =
  let word = Decode.map (fun () -> "none") Decode.flag in
  let b = Colour_decoder.light_or "glow" [ ("none", word) ] Rgb.show in
  let reads = Piece.reads String.equal b and refuses = Piece.refuses b in
  reads "(c (none))" "none";
  reads "(c 3)" (Rgb.show (Rgb.grey 3.));
  reads "(c (rgb 1 2 3))" (Rgb.show (Rgb.v 1. 2. 3.));
  refuses "(c (nine))" [ "4 unknown glow `nine`; did you mean `none`?" ];
  refuses "(c -3)" [ "4 a colour must not be negative, but is `-3`" ]

let textures () =
  texture "(c .25)" (grey 0.25);
  texture "(c (rgb 1 0 .5))" (Constant (Rgb.v 1. 0. 0.5));
  texture "(c (checker 0 1))"
    (Checker { even = grey 0.; odd = grey 1.; scale = 1. });
  texture "(c (checker (scale .5) (rgb 1 0 0) (checker 1 0 (scale 2))))"
    (Checker
       {
         even = Constant (Rgb.v 1. 0. 0.);
         odd = Checker { even = grey 1.; odd = grey 0.; scale = 2. };
         scale = 0.5;
       });
  texture "(c (noise 0 1))"
    (Noise { first = grey 0.; second = grey 1.; scale = 1.; octaves = 1 });
  texture "(c (noise (octaves 64) (rgb 1 0 0) (scale 3) 1))"
    (Noise
       {
         first = Constant (Rgb.v 1. 0. 0.);
         second = grey 1.;
         scale = 3.;
         octaves = 64;
       })

let no_textures () =
  no_texture "(c 2)" [ "4 a colour must be from 0 to 1, but is `2`" ];
  no_texture "(c (checker 0 2))"
    [ "15 a colour must be from 0 to 1, but is `2`" ];
  no_texture "(c (checker 0))"
    [ "4 (checker ...): two colours are needed, not 1" ];
  no_texture "(c (checker 0 0 0))"
    [ "4 (checker ...): two colours are needed, not 3" ];
  no_texture "(c (checker 0 1 (scale 0)))"
    [ "24 (scale ...) must be above 0, but is `0`" ];
  no_texture "(c (noise))" [ "4 (noise ...): two colours are needed, not 0" ];
  no_texture "(c (noise 0 1 (scale -1) (octaves 0)))"
    [
      "22 (scale ...) must be above 0, but is `-1`";
      "35 (octaves ...) must be from 1 to 64, but is `0`";
    ];
  no_texture "(c (noise 0 1 (octaves 1.5)))"
    [ "24 `1.5` is not a whole number" ];
  no_texture "(c (image))" [ "4 expected (image FILE), found nothing" ];
  no_texture "(c (image (scale 2)))" [ "11 expected a name, not (scale ...)" ]

let suite =
  ( "colour decoder",
    [
      case "a light is grey, or red, green and blue, as bright as you like"
        lights;
      case "what is no light is told" no_lights;
      any_light;
      case "a reflectance has no part above 1" shares;
      case "a colour of light may be one of some cases instead" cases;
      case "a texture is one colour, or a checker of textures" textures;
      case "what is no texture is told" no_textures;
    ] )

open Candor_oracle
open Called

let matte color = Printf.sprintf "(material (matte (color %s)))" color

let calls () =
  check "a checker" Textures
    [ camera; ball (matte "(checker .1 .9)") ]
    [ ("matte surface", 3) ];
  check "noise" Textures
    [
      camera; "(material m (mirror (color (noise .1 .9))))"; ball "(material m)";
    ]
    [ ("material m", 3) ];
  check "on metal" Textures
    [
      camera;
      ball "(material (metal (reflectance (checker .1 .9)) (roughness .1)))";
    ]
    [ ("metal surface", 3) ];
  check "plain" Textures [ camera; ball (matte ".5") ] [];
  check "not in use" Textures
    [ camera; "(material m (matte (color (checker 0 1))))"; ball "" ]
    []

let suite = ("textures", [ Law.example "colours that vary call" calls ])

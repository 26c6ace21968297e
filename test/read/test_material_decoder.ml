open Candor_colour
open Candor_scene
open Text

let grey k = Texture.Constant (Rgb.grey k)

let read material =
  match
    (only_surface
       (Printf.sprintf "(sphere (center 0 0 0) (radius 1) (material %s))"
          material))
      .material
  with
  | Some (Inline m) -> m
  | Some (Named _) | None -> Alcotest.fail "not a material of its own"

let check s m = Alcotest.(check bool) s true (Material.equal m (read s))

let kinds () =
  check "(matte (color .8))" (Matte { color = grey 0.8 });
  check "(matte (color (rgb .1 .2 .3)))"
    (Matte { color = Constant (Rgb.v 0.1 0.2 0.3) });
  check "(phong (color 1) (specular .5) (shininess 20))"
    (Phong { color = grey 1.; specular = Rgb.grey 0.5; shininess = 20. });
  check "(glazed (color 0) (mirror (rgb 1 0 0)))"
    (Glazed { color = grey 0.; mirror = Rgb.v 1. 0. 0. })

let defaults () =
  check "(mirror)" (Mirror { color = grey 1. });
  check "(mirror (color .5))" (Mirror { color = grey 0.5 });
  check "(matte (color (checker 0 1)))"
    (Matte { color = Checker { even = grey 0.; odd = grey 1.; scale = 1. } });
  Alcotest.(check bool)
    "none is matte .5" true
    (Material.equal Material.default (Matte { color = grey 0.5 }))

let textures () =
  check "(matte (color (checker (scale 2) (checker 0 .5) (rgb 1 0 0))))"
    (Matte
       {
         color =
           Checker
             {
               even = Checker { even = grey 0.; odd = grey 0.5; scale = 1. };
               odd = Constant (Rgb.v 1. 0. 0.);
               scale = 2.;
             };
       })

let names () =
  let s =
    ok_forms
      "(sphere (center 0 0 0) (radius 1) (material \"my red\")) (material \"my \
       red\" (mirror))"
  in
  match (s.surfaces, s.materials) with
  | [ { material = Some (Named a); _ } ], [ { name = b; _ } ] ->
      Alcotest.(check string) "name" b a
  | _ -> Alcotest.fail "a name is lost"

let suite =
  ( "material decoder",
    [
      case "each material is read" kinds;
      case "what is left out has its default" defaults;
      case "textures nest" textures;
      case "a material may be used by its name before it is defined" names;
    ] )

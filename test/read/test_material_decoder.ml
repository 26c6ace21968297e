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

let check_all s m = Alcotest.(check bool) s true (Material.equal m (read s))
let check s kind = check_all s (Material.v kind)

let kinds () =
  check "(matte (color .8))" (Matte { color = grey 0.8 });
  check "(matte (color (rgb .1 .2 .3)))"
    (Matte { color = Constant (Rgb.v 0.1 0.2 0.3) });
  check "(phong (color 1) (specular .5) (shininess 20))"
    (Phong { color = grey 1.; specular = Rgb.grey 0.5; shininess = 20. });
  check "(glazed (color 0) (mirror (rgb 1 0 0)))"
    (Glazed { color = grey 0.; mirror = Rgb.v 1. 0. 0. });
  check
    "(glass (index 1.5) (color .9) (absorption (rgb 0 1 200)) (dispersion 30))"
    (Glass
       {
         index = 1.5;
         color = grey 0.9;
         absorption = Rgb.v 0. 1. 200.;
         dispersion = Some 30.;
       });
  check "(metal (reflectance (checker 0 1)) (roughness .1))"
    (Metal
       {
         reflectance = Checker { even = grey 0.; odd = grey 1.; scale = 1. };
         roughness = 0.1;
       });
  check "(plastic (color .2) (index 1.4) (roughness 0))"
    (Plastic { color = grey 0.2; index = 1.4; roughness = 0. });
  check
    "(translucent (index 1.3) (scattering (rgb 1 2 3)) (absorption .1) \
     (anisotropy -.9))"
    (Translucent
       {
         index = 1.3;
         scattering = Rgb.v 1. 2. 3.;
         absorption = Rgb.grey 0.1;
         anisotropy = -0.9;
       });
  check_all "(emitter (radiance (rgb 1 2 3)))"
    { kind = Emitter; emission = Rgb.v 1. 2. 3. }

let emission () =
  let check s kind =
    check_all s { Material.kind; emission = Rgb.v 1. 2. 300. }
  in
  let e = "(emission (rgb 1 2 300))" in
  let color = grey 0.5 and specular = Rgb.black in
  check ("(matte (color .5) " ^ e ^ ")") (Matte { color });
  check
    ("(phong " ^ e ^ " (color .5) (specular 0) (shininess 1))")
    (Phong { color; specular; shininess = 1. });
  check ("(mirror " ^ e ^ ")") (Mirror { color = grey 1. });
  check
    ("(glazed (color .5) (mirror 0) " ^ e ^ ")")
    (Glazed { color; mirror = Rgb.black });
  check
    ("(glass (index 1) " ^ e ^ ")")
    (Glass
       {
         index = 1.;
         color = grey 1.;
         absorption = Rgb.black;
         dispersion = None;
       });
  check
    ("(metal (reflectance .5) (roughness 1) " ^ e ^ ")")
    (Metal { reflectance = color; roughness = 1. });
  check
    ("(plastic (color .5) (index 2) (roughness 1) " ^ e ^ ")")
    (Plastic { color; index = 2.; roughness = 1. });
  check
    ("(translucent (index 2) (scattering 0) (absorption 0) " ^ e ^ ")")
    (Translucent
       {
         index = 2.;
         scattering = Rgb.black;
         absorption = Rgb.black;
         anisotropy = 0.;
       })

let defaults () =
  check "(mirror)" (Mirror { color = grey 1. });
  check "(mirror (color .5))" (Mirror { color = grey 0.5 });
  check "(matte (color (checker 0 1)))"
    (Matte { color = Checker { even = grey 0.; odd = grey 1.; scale = 1. } });
  check "(glass (index 1.5))"
    (Glass
       {
         index = 1.5;
         color = grey 1.;
         absorption = Rgb.black;
         dispersion = None;
       });
  check "(translucent (index 1) (scattering 1) (absorption 2))"
    (Translucent
       {
         index = 1.;
         scattering = Rgb.grey 1.;
         absorption = Rgb.grey 2.;
         anisotropy = 0.;
       });
  check "(matte (color (noise 0 1)))"
    (Matte
       {
         color =
           Noise { first = grey 0.; second = grey 1.; scale = 1.; octaves = 1 };
       });
  Alcotest.(check bool)
    "none is matte .5" true
    (Material.equal Material.default (Material.v (Matte { color = grey 0.5 })))

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
       });
  check
    "(matte (color (noise (octaves 7) 0 (noise 0 (checker 0 1)) (scale .5))))"
    (Matte
       {
         color =
           Noise
             {
               first = grey 0.;
               second =
                 Noise
                   {
                     first = grey 0.;
                     second =
                       Checker { even = grey 0.; odd = grey 1.; scale = 1. };
                     scale = 1.;
                     octaves = 1;
                   };
               scale = 0.5;
               octaves = 7;
             };
       })

let refused () =
  let refuses material expected =
    errors material expected
      (scene (Printf.sprintf "\n(material m %s)" material))
  in
  refuses "(glass)" [ "2:13 (glass ...) needs (index N)" ];
  refuses "(glass (index 0))"
    [ "2:27 (index ...) must be from 0.001 to 1000, but is `0`" ];
  refuses "(glass (index 1.5) (dispersion 0))"
    [ "2:44 (dispersion ...) must be above 0, but is `0`" ];
  refuses "(glass (index 1.5) (absorption -1) (color 2))"
    [
      "2:44 a colour must not be negative, but is `-1`";
      "2:55 a colour must be from 0 to 1, but is `2`";
    ];
  refuses "(metal (color .9) (roughness 2))"
    [
      "2:20 unknown field `color` in (metal ...)";
      "2:42 (roughness ...) must be from 0 to 1, but is `2`";
    ];
  refuses "(metal)"
    [
      "2:13 (metal ...) needs (reflectance COLOUR)";
      "2:13 (metal ...) needs (roughness A)";
    ];
  refuses "(plastic (color .9) (index 1.5))"
    [ "2:13 (plastic ...) needs (roughness A)" ];
  refuses "(translucent (index 1) (scattering 1) (absorption 1) (anisotropy 1))"
    [ "2:78 (anisotropy ...) must be above -1 and below 1, but is `1`" ];
  refuses "(emitter (emission 4))"
    [ "2:22 unknown field `emission` in (emitter ...)" ];
  refuses "(emitter (radiance -4))"
    [ "2:32 a colour must not be negative, but is `-4`" ];
  refuses "(matte (color 1) (emission (rgb 1 1)))"
    [ "2:40 expected (rgb R G B), found 2 words" ]

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
      case "every material but an emitter may emit besides" emission;
      case "what is no material is told" refused;
      case "what is left out has its default" defaults;
      case "textures nest" textures;
      case "a material may be used by its name before it is defined" names;
    ] )

open Candor_space
open Candor_colour
open Candor_scene
open Candor_optics
open Candor_oracle
open Candor_scene_made

let here = { Drawn.some_point with point = Point.v 1.5 0.5 0.5 }
let red = Rgb.v 0.5 0. 0.
let blue = Rgb.v 0. 0. 0.5

let board =
  Texture.Checker { even = Constant red; odd = Constant blue; scale = 1. }

let dark =
  Texture.Checker
    { even = Constant Rgb.black; odd = Constant Rgb.black; scale = 1. }

let half_dark =
  Texture.Checker { even = Constant Rgb.black; odd = dark; scale = 1. }

let half_lit = Texture.Checker { even = dark; odd = Constant red; scale = 1. }

let lobes_of m =
  let { Candor_surface.Local.normal; _ } = here in
  Lobes.compile m here ~normal ~view:(normal :> Vec.t)

let check name kind ~diffuse ~highlight ~mirror =
  let l = lobes_of (Material.v kind) in
  let rgb = Alcotest.testable Rgb.pp Rgb.equal in
  Alcotest.check rgb (name ^ ", diffuse") diffuse l.diffuse;
  Alcotest.check rgb (name ^ ", mirror") mirror l.mirror;
  Alcotest.(check bool) (name ^ ", highlight") true (l.highlight = highlight)

let lobes () =
  let black = Rgb.black in
  check "matte"
    (Matte { color = board })
    ~diffuse:blue ~highlight:None ~mirror:black;
  check "phong"
    (Phong { color = board; specular = red; shininess = 7. })
    ~diffuse:blue
    ~highlight:(Some { specular = red; shininess = 7. })
    ~mirror:black;
  check "mirror"
    (Mirror { color = board })
    ~diffuse:black ~highlight:None ~mirror:blue;
  check "glazed: the mirror is not multiplied by the colour"
    (Glazed { color = board; mirror = red })
    ~diffuse:blue ~highlight:None ~mirror:red

let asks () =
  let check name (kind : Material.kind) diffuses mirrors =
    let m = Material.v kind in
    Alcotest.(check (pair bool bool))
      name (diffuses, mirrors)
      (Lobes.diffuses m, Lobes.mirrors m)
  in
  check "matte" (Matte { color = board }) true false;
  check "black matte" (Matte { color = half_dark }) false false;
  check "matte, lit in one cell" (Matte { color = half_lit }) true false;
  check "black phong that shines"
    (Phong { color = dark; specular = red; shininess = 1. })
    true false;
  check "phong without shine"
    (Phong { color = board; specular = Rgb.black; shininess = 1. })
    true false;
  check "black phong"
    (Phong { color = dark; specular = Rgb.black; shininess = 1. })
    false false;
  check "mirror" (Mirror { color = board }) false true;
  check "black mirror" (Mirror { color = dark }) false false;
  check "glazed" (Glazed { color = board; mirror = red }) true true;
  check "glazed on black" (Glazed { color = dark; mirror = red }) false true;
  check "glazed that does not reflect"
    (Glazed { color = board; mirror = Rgb.black })
    true false

(* {1 Coats and gloss} *)

let metal roughness =
  Material.v (Metal { reflectance = Constant red; roughness })

let plastic ?(index = 1.5) roughness =
  Material.v (Plastic { color = Constant red; index; roughness })

let seen_at m cos =
  let { Candor_surface.Local.normal; _ } = here in
  let frame = Frame.of_dir normal in
  let aside = Vec.scale (sqrt (1. -. (cos *. cos))) (frame.u :> Vec.t) in
  let view = Vec.add aside (Vec.scale cos (normal :> Vec.t)) in
  Lobes.compile m here ~normal ~view:(Vec.scale 7. view)

let smooth () =
  let fresnel cos = Refraction.reflectance { from = 1.; into = 1.5 } cos in
  List.iter
    (fun cos ->
      let m = seen_at (metal 0.) cos in
      let rise = (1. -. cos) ** 5. in
      Near.rgb ~within:1e-12 "metal, after Schlick"
        (Rgb.v (0.5 +. (0.5 *. rise)) rise rise)
        m.mirror;
      Alcotest.(check bool) "and nothing else" true (m.gloss = None);
      let p = seen_at (plastic 0.) cos in
      Near.rgb ~within:1e-12 "plastic, after Fresnel"
        (Rgb.grey (fresnel cos))
        p.mirror;
      Alcotest.(check bool) "over a base" true (Option.is_some p.gloss))
    [ 1.; 0.7; 0.3; 0.01 ]

let rough () =
  List.iter
    (fun m ->
      let l = seen_at m 0.5 in
      Near.rgb "no mirror" Rgb.black l.mirror;
      Near.rgb "not matte" Rgb.black l.diffuse;
      Alcotest.(check bool) "gloss" true (Option.is_some l.gloss))
    [ metal 0.1; plastic 1. ]

let glosses () =
  let check name m expected =
    Alcotest.(check (triple bool bool bool))
      name expected
      (Lobes.glosses m, Lobes.mirrors m, Lobes.responds m)
  in
  check "rough metal" (metal 0.1) (true, false, true);
  check "smooth metal" (metal 0.) (false, true, false);
  check "rough plastic" (plastic 0.1) (true, false, true);
  check "smooth plastic" (plastic 0.) (true, true, true);
  check "smooth plastic of index 1" (plastic ~index:1. 0.) (true, false, true);
  check "black smooth plastic"
    (Material.v (Plastic { color = dark; index = 1.5; roughness = 0. }))
    (false, true, false);
  check "matte" (Material.v (Matte { color = board })) (false, false, true);
  check "an emitter" (Material.v Emitter) (false, false, false)

let sound m =
  let l = lobes_of m in
  let shows =
    not
      (Rgb.is_black l.diffuse
      && Option.fold ~none:true
           ~some:(fun (h : Lobes.highlight) -> Rgb.is_black h.specular)
           l.highlight)
  in
  ((not shows) || Lobes.diffuses m) && (Rgb.is_black l.mirror || Lobes.mirrors m)

let suite =
  ( "lobes",
    [
      Law.example "each material's lobes, colours taken at the point" lobes;
      Law.example "which materials diffuse and which mirror" asks;
      Law.example "a smooth coat is a mirror that depends on the angle" smooth;
      Law.example "rough metal and plastic are all gloss" rough;
      Law.example "which materials have gloss, and respond to light" glosses;
      Law.law ~print:Material.show "a lobe that is not black is asked for"
        Drawn.material sound;
    ] )

open Candor_space
open Candor_colour
open Candor_scene
open Candor_optics
open Candor_effect
open Candor_oracle
open QCheck2

let unit v = (Dir.of_vec_or Dir.x v :> Vec.t)

let lobes ?highlight diffuse : Lobes.t =
  { diffuse; highlight; mirror = Rgb.black; gloss = None }

type case = {
  normal : Dir.t;
  view : Vec.t;
  toward : Vec.t;
  diffuse : Rgb.t;
  specular : Rgb.t;
  shininess : float;
  irradiance : Rgb.t;
}

let case =
  let open Gen in
  let color = Candor_scene_made.Drawn.rgb in
  let+ n = Draw.unit
  and+ view = bind Draw.unit Draw.stretched
  and+ toward = bind Draw.unit Draw.stretched
  and+ diffuse = color
  and+ specular = color
  and+ e = color
  and+ shininess = Draw.pick [ 0.; 1.; 2.; 33.; 500. ] in
  {
    normal = Dir.of_vec_or Dir.z n;
    view;
    toward;
    diffuse;
    specular;
    shininess;
    irradiance = Rgb.scale 7. e;
  }

let show c =
  Printf.sprintf "n %s view %s light %s, diffuse %s, specular %s ^ %g, E %s"
    (Draw.show_vec (c.normal :> Vec.t))
    (Draw.show_vec c.view) (Draw.show_vec c.toward) (Rgb.show c.diffuse)
    (Rgb.show c.specular) c.shininess (Rgb.show c.irradiance)

let outgoing ?highlight c =
  Direct.matte.outgoing
    (lobes ?highlight c.diffuse)
    ~normal:c.normal ~view:c.view
    { toward = c.toward; irradiance = c.irradiance }

let highlight c : Lobes.highlight =
  { specular = c.specular; shininess = c.shininess }

let cosine c = Vec.dot (c.normal :> Vec.t) (unit c.toward)

let lambert c =
  let expected =
    if cosine c > 0. then
      Rgb.mul c.diffuse (Rgb.scale (cosine c /. Float.pi) c.irradiance)
    else Rgb.black
  in
  Float.abs (cosine c) < 1e-12 || Lit.close_rgb (outgoing c) expected

(* specular·E·max(0, n·h)^N, h halfway between the light and the viewer. *)
let blinn c =
  let half = unit (Vec.add (unit c.toward) (unit c.view)) in
  let cos = Float.max 0. (Vec.dot (c.normal :> Vec.t) half) in
  let shine =
    Rgb.mul c.specular (Rgb.scale (cos ** c.shininess) c.irradiance)
  in
  let expected =
    if cosine c > 0. then Rgb.add (outgoing c) shine else Rgb.black
  in
  Float.abs (cosine c) < 1e-12
  || Lit.close_rgb ~within:1e-11 (outgoing ~highlight:(highlight c) c) expected

let behind c =
  cosine c > 0. || Rgb.is_black (outgoing ~highlight:(highlight c) c)

let stretch c =
  let stretched =
    { c with view = Vec.scale 8. c.view; toward = Vec.scale 0.125 c.toward }
  in
  Rgb.equal
    (outgoing ~highlight:(highlight c) c)
    (outgoing ~highlight:(highlight c) stretched)

let by_hand () =
  let lit ?highlight toward view =
    Direct.matte.outgoing
      (lobes ?highlight (Rgb.grey 0.5))
      ~normal:Dir.z ~view
      { toward; irradiance = Rgb.grey Float.pi }
  in
  let up = Vec.v 0. 0. 2. in
  Lit.check_close "facing" (Rgb.grey 0.5) (lit up up);
  Lit.check_close "at 60 degrees" (Rgb.grey 0.25)
    (lit (Vec.v (sqrt 3.) 0. 1.) up);
  Alcotest.check Lit.rgb "grazing" Rgb.black (lit (Vec.v 1. 0. 0.) up);
  let highlight = { Lobes.specular = Rgb.grey 0.25; shininess = 2. } in
  Lit.check_close "the mirror direction"
    (Rgb.grey ((0.5 /. sqrt 2.) +. (0.25 *. Float.pi)))
    (lit ~highlight (Vec.v 1. 0. 1.) (Vec.v (-1.) 0. 1.));
  (* h is at 45 degrees from the normal: cos² is 1/2. *)
  Lit.check_close "off it"
    (Rgb.grey (0.5 +. (0.125 *. Float.pi)))
    (lit ~highlight up (Vec.v 1. 0. 0.));
  Lit.check_close "the viewer against the light" (Rgb.grey 0.5)
    ( lit ~highlight:{ highlight with shininess = 1. } up (Vec.v 0. 0. (-1.))
    |> fun c ->
      Rgb.v
        (c.r -. (0.25 *. Float.pi))
        (c.g -. (0.25 *. Float.pi))
        (c.b -. (0.25 *. Float.pi)) )

(* Lit from z = 3, seen from the same side. *)
let light_at z = Printf.sprintf "(light (point (at 0 0 %g) (intensity 9)))" z

let term_of s =
  Direct.term Direct.matte
    (List.map
       (fun light -> { Direct.light; reach = Direct.always })
       s.Scene.lights)

let shade s o d =
  let tally = Tally.make () in
  let value =
    term_of s Lit.no_recursion tally
      (Lit.vertex (Lit.hit s o d) (Vec.neg (Lit.ray o d).direction))
  in
  (value, tally)

let from s z = shade s (0.25, 0.125, z) (0., 0., -.z)
let box m = "(box (min -1 -1 0) (max 1 1 0) " ^ m ^ ")"

let surfaces =
  [
    (fun m -> "(triangle (-1 -1 0) (3 -1 0) (-1 3 0) " ^ m ^ ")");
    (fun m -> "(triangle (-1 -1 0) (-1 3 0) (3 -1 0) " ^ m ^ ")");
    box;
    (fun m -> "(quadric (plane (normal 0 0 1) (offset 0)) " ^ m ^ ")");
    (fun m -> "(quadric (plane (normal 0 0 -1) (offset 0)) " ^ m ^ ")");
  ]

let materials =
  [
    "(material (matte (color .5)))";
    "(material (phong (color .5) (specular .5) (shininess 8)))";
    "(material (glazed (color .5) (mirror .2)))";
  ]

let both_sides () =
  List.iter
    (fun surface ->
      List.iter
        (fun material ->
          let form = surface material in
          let near, _ = from (Lit.scene [ form; light_at 3. ]) 5.
          and far, _ = from (Lit.scene [ form; light_at (-3.) ]) (-5.)
          and hidden, _ = from (Lit.scene [ form; light_at (-3.) ]) 5. in
          Alcotest.(check bool) "lit" false (Rgb.is_black near);
          Alcotest.check Lit.rgb (form ^ " from both sides") near far;
          Alcotest.check Lit.rgb (form ^ ", lit from behind") Rgb.black hidden)
        materials)
    surfaces

let inside () =
  let ball = "(sphere (center 0 0 0) (radius 2))" in
  let value, _ =
    shade (Lit.scene [ ball; light_at 0. ]) (0., 0., 0.) (0., 0., -1.)
  in
  Lit.check_close "from the centre of a ball"
    (Rgb.grey (0.5 *. 9. /. 4. /. Float.pi))
    value;
  let value, _ =
    shade (Lit.scene [ ball; light_at 9. ]) (0., 0., 0.) (0., 0., 1.)
  in
  Alcotest.check Lit.rgb "a light outside, behind the wall" Rgb.black value

(* Without shadows, what is in the way does not count and no ray is traced. *)
let no_shadow_rays () =
  let value, tally = from (Lit.scene [ box ""; box ""; light_at 3. ]) 5. in
  Alcotest.(check bool) "lit" false (Rgb.is_black value);
  Alcotest.(check int) "rays" 0 (Tally.get tally Shadow_rays)

let never : Direct.reach =
  let asked _ _ _ = Alcotest.fail "a light was asked for in vain" in
  { surface = asked; space = asked }

let no_questions () =
  let ask s z =
    let lamps =
      List.map (fun light -> { Direct.light; reach = never }) s.Scene.lights
    in
    let term = Direct.term Direct.matte lamps in
    term Lit.no_recursion (Tally.make ())
      (Lit.vertex (Lit.hit s (0.25, 0.125, z) (0., 0., -.z)) (Vec.v 0. 0. z))
  in
  Alcotest.check Lit.rgb "behind" Rgb.black
    (ask (Lit.scene [ box ""; light_at (-3.) ]) 5.);
  Alcotest.check Lit.rgb "a mirror" Rgb.black
    (ask (Lit.scene [ box "(material (mirror))"; light_at 3. ]) 5.);
  Alcotest.check Lit.rgb "outside a spot's cone" Rgb.black
    (ask
       (Lit.scene
          [
            box "";
            "(light (spot (at 0 0 3) (toward 9 0 3) (intensity 1) (inner 3) \
             (outer 5)))";
          ])
       5.)

(* A triangle's normals bend its shading, not where its light comes from. *)
let bent_normals () =
  let s normals =
    Lit.scene
      [
        "(triangle (-1 -1 0) (3 -1 0) (-1 3 0) (normals " ^ normals ^ "))";
        light_at 3.;
      ]
  in
  let flat, _ = from (s "(0 0 1) (0 0 1) (0 0 1)") 5.
  and bent, _ = from (s "(0 1 1) (0 1 1) (0 1 1)") 5. in
  let plain, _ =
    from
      (Lit.scene [ "(triangle (-1 -1 0) (3 -1 0) (-1 3 0))"; light_at 3. ])
      5.
  in
  Lit.check_close "flat normals change nothing" plain flat;
  Alcotest.(check bool) "bent ones do" true (bent.r < 0.8 *. flat.r)

let law name f = Law.law ~print:show name case f

let suite =
  ( "direct light",
    [
      law "Lambert: diffuse/pi times E times the cosine" lambert;
      law "Blinn-Phong: plus specular times E times (n.h)^N" blinn;
      law "a light behind gives nothing" behind;
      law "the lengths of directions do not count" stretch;
      Law.example "values worked out by hand" by_hand;
      Law.example "both sides of flat surfaces shade alike" both_sides;
      Law.example "the inside of a ball" inside;
      Law.example "lights without shadows trace no rays" no_shadow_rays;
      Law.example "lights behind, beside or of no use are not asked for"
        no_questions;
      Law.example "interpolated normals" bent_normals;
    ] )

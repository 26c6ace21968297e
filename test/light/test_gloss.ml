(* Rough metal and plastic under area lights: by the light, by the gloss, and
   by both together. *)

open Candor_effect
open Candor_oracle

let scene ?(n = 24) ?(spp = 16) material more =
  [
    Measure.look ~from:"3 2 1" "0 0 0";
    Measure.settings ~spp n;
    Printf.sprintf "(quadric (plane (normal 0 1 0) (offset 0)) (material %s))"
      material;
    "(sphere (center -3 2.2 -1) (radius .7) (material (emitter (radiance (rgb \
     5 3 1)))))";
    "(box (min -.5 2 -3) (max 1.5 2 -1) (material (emitter (radiance (rgb 1 2 \
     4)))))";
  ]
  @ more

let materials =
  [
    "(metal (reflectance (rgb .9 .7 .4)) (roughness .15))";
    "(metal (reflectance .8) (roughness .5))";
    "(plastic (color (rgb .3 .5 .7)) (index 1.5) (roughness .2))";
    "(plastic (color (rgb .3 .5 .7)) (index 1.5) (roughness .6))";
  ]

let modes () =
  List.iter
    (fun material ->
      let forms = scene material [] in
      Measure.agree ~within:0.03 material (Measure.v forms)
        (Measure.v (Measure.indirect :: forms)))
    (materials @ [ "(plastic (color .5) (index 1.5) (roughness 0))" ])

let by_gloss () =
  List.iter
    (fun material ->
      let forms = Measure.indirect :: scene ~n:32 material [] in
      Measure.agree ~within:0.05 material (Measure.v forms)
        (Measure.changed Measure.by_material forms))
    materials

(* Without indirect light only the lights are seen; the light alone must do. *)
let light_alone : Effect.t * Term.t -> _ = function
  | Gloss, _ -> None
  | other -> Some other

let shared () =
  let forms = scene (List.hd materials) [] in
  let both = Measure.v forms and one = Measure.changed light_alone forms in
  if not (one.mean.r < 0.98 *. both.mean.r) then
    Alcotest.failf "the light alone counts %g of %g" one.mean.r both.mean.r

(* Fog takes its part of the light that either way finds. *)
let fog () =
  let text =
    "(fog (extinction .2) (albedo 0) (within (min -9 -9 -9) (max 9 9 9)))"
  in
  let forms = scene (List.nth materials 1) [ text ] in
  let scene = Candor_scene_made.Written.scene forms in
  let veil = Fog.veil (Option.get scene.fog).value in
  let lights = Candor_optics.Area_lights.make scene
  and tracer = Tracer.still (Candor_optics.Skin.surface scene) in
  let veiled : Effect.t * Term.t -> _ = function
    | Gloss, _ -> Some (Effect.Gloss, Glossy.term ~veil lights tracer)
    | other -> Some other
  in
  Measure.agree ~within:0.03 "in fog"
    (Measure.changed veiled forms)
    (Measure.v (Measure.indirect :: forms))

let phong () =
  let floor =
    "(phong (color (rgb .5 .25 .1)) (specular (rgb .2 .5 .3)) (shininess 20))"
  in
  (* The definition, summed over the ball's solid angle. *)
  let open Candor_space in
  let unit v = Option.get (Dir.of_vec v) in
  let center = Vec.v (-1.5) 1. (-0.25) and radius = 0.5 in
  let view = unit (Vec.v 3. 2. 1.) in
  let normal = Dir.y in
  let distance = Vec.norm center in
  let sine = radius /. distance in
  let low = 1. -. sqrt (1. -. (sine *. sine)) in
  let frame = Frame.of_dir (unit center) in
  let steps = 200 in
  let sum = ref Candor_colour.Rgb.black in
  for i = 0 to steps - 1 do
    for j = 0 to steps - 1 do
      let part k = (float_of_int k +. 0.5) /. float_of_int steps in
      let z = 1. -. (low *. part i) and turn = 2. *. Float.pi *. part j in
      let aside = sqrt (1. -. (z *. z)) in
      let d =
        Candor_sample.Warp.to_world frame
          (Vec.v (aside *. cos turn) (aside *. sin turn) z)
      in
      let half = unit (Vec.add (d :> Vec.t) (view :> Vec.t)) in
      let matte = Dir.dot normal d /. Float.pi
      and shine = Float.max 0. (Dir.dot normal half) ** 20. in
      let open Candor_colour in
      let value =
        Rgb.add
          (Rgb.scale matte (Rgb.v 0.5 0.25 0.1))
          (Rgb.scale shine (Rgb.v 0.2 0.5 0.3))
      in
      sum := Rgb.add !sum value
    done
  done;
  let solid_angle = 2. *. Float.pi *. low in
  let expected =
    Candor_colour.Rgb.scale (solid_angle /. float_of_int (steps * steps)) !sum
  in
  Measure.is "phong" expected
    (Measure.v
       [
         Measure.look ~from:"3 2 1" "0 0 0";
         Measure.settings 24;
         "(quadric (plane (normal 0 1 0) (offset 0)) (material " ^ floor ^ "))";
         "(sphere (center -1.5 1 -.25) (radius .5) (material (emitter \
          (radiance 1))))";
       ])

let suite =
  ( "gloss",
    [
      Law.example "ray tracing shows what path tracing shows of lights" modes;
      Law.example "light found by the gloss alone is the same" by_gloss;
      Law.example "the light alone is not all, for the gloss takes its share"
        shared;
      Law.example "fog takes from both ways" fog;
      Law.example "phong adds up its definition over a light" phong;
    ] )

open Candor_space
open Candor_colour
open Candor_optics
open Candor_effect
open Candor_oracle

let floor = "(box (min -9 -1 -9) (max 9 0 9) (material (matte (color .5))))"

let lamp ?(at = "0 3 0") () =
  "(sphere (center " ^ at
  ^ ") (radius 1) (material (emitter (radiance (rgb 4 2 1)))))"

let scene more = Lit.scene (floor :: lamp () :: more)

let term ?veil ?(goes_on = false) scene =
  let lights = Area_lights.make scene in
  Soft_shadows.term Scattering.matte
    ~goes_on:(fun _ -> goes_on)
    (Soft_shadows.estimate ?veil lights (Lit.tracer scene))

let vertex ?path scene =
  Followed.vertex ?path scene (3., 0.5, 1.) (-3., -0.5, -1.)

(* π L (r/d)² cos times the BRDF .5/π; a sphere seen from its axis has one
   cosine on the average, so 4000 paths are close. *)
let full = Rgb.scale (0.5 /. 9.) (Rgb.v 4. 2. 1.)

let mean ?veil scene =
  let term = term ?veil scene in
  Followed.mean 4000 (fun path -> (Followed.v term (vertex ~path scene)).value)

let lit () =
  Lit.check_close ~within:1e-3 "the closed form" full (mean (scene []))

let counted () =
  let s = scene [] in
  let f = Followed.v (term s) (vertex s) in
  Alcotest.(check int) "one ray" 1 (Tally.get f.tally Emitter_rays);
  Alcotest.(check int) "none of others" 0 (Tally.get f.tally Shadow_rays);
  let f =
    Followed.v (term s) (Followed.vertex s (3., -5., 1.) (-0.1, 1., 0.))
  in
  Alcotest.check Lit.rgb "a side that faces away" Rgb.black f.value;
  Alcotest.(check int) "traces none" 0 (Tally.get f.tally Emitter_rays)

let blocked () =
  List.iter
    (fun material ->
      let s =
        scene
          [ "(box (min -2 1 -2) (max 2 1.5 2) (material " ^ material ^ "))" ]
      in
      let s' = Followed.vertex s (3., 0.5, 1.) (-3., -0.5, -1.) in
      Alcotest.check Lit.rgb material Rgb.black (Followed.v (term s) s').value)
    [ "(matte (color 1))"; "(glass (index 1))"; "(emitter (radiance 0))" ]

(* Only the light that was asked for counts: others in its way have chances of
   their own. *)
let other_light () =
  let s =
    scene
      [
        "(sphere (center 0 1.5 0) (radius .5) (material (emitter (radiance \
         1))))";
      ]
  in
  let lights = Area_lights.make s in
  let one = Soft_shadows.estimate lights (Lit.tracer s) in
  let term = Soft_shadows.term Scattering.matte ~goes_on:(fun _ -> false) one in
  let near = 0.5 /. 9. in
  let value =
    Followed.mean 6000 (fun path ->
        (Followed.v term
           (Followed.vertex ~path s (3., 0.5, 1.) (-3., -0.5, -1.)))
          .value)
  in
  (* Both fill the same cone, so the near one hides the far one. *)
  Lit.check_close ~within:4e-3 "the near one alone" (Rgb.grey near) value

let veiled () =
  let veil _ point source =
    match (source : Illumination.source) with
    | At light ->
        Alcotest.(check bool)
          "from the light to the point" true
          ((light : Point.t).y > 1.9 && (point : Point.t).y < 0.1);
        Rgb.v 1. 0.5 0.
    | Along _ -> Alcotest.fail "an area light has a place"
  in
  Lit.check_close ~within:1e-3 "what the veil lets through"
    (Rgb.mul (Rgb.v 1. 0.5 0.) full)
    (mean ~veil (scene []))

(* Where the path goes on by itself the two ways share each direction: shares
   of a path that arrives and of one that is sent add up to 1. *)
let shares () =
  let s = scene [] in
  let lights = Area_lights.make s in
  for i = 0 to 499 do
    let path = Followed.path i in
    let v = vertex ~path s in
    let receiver = Receiver.of_vertex Scattering.matte ~goes_on:true v in
    let alone =
      Soft_shadows.estimate lights (Lit.tracer s) (Tally.make ()) path
        { receiver with density = (fun _ -> 0.) }
    and shared =
      Soft_shadows.estimate lights (Lit.tracer s) (Tally.make ()) path receiver
    in
    let sampled =
      Area_lights.sample lights receiver.vantage ~choice:(Path.one path Emitter)
        (Path.pair path Emitter_direction)
    in
    match sampled with
    | None -> Alcotest.fail "the light is seen"
    | Some { direction; _ } ->
        let arrival =
          Path.Spread
            { density = receiver.density direction; from = receiver.vantage }
        in
        let found = { path with journey = { path.journey with arrival } } in
        let hit =
          Option.get
            ((Lit.tracer s).nearest (Tally.make ()) path
               (receiver.spawn (direction :> Vec.t)))
        in
        let rest = Soft_shadows.weigh lights found hit in
        Lit.check_close ~within:1e-9 "together all of it" alone
          (Rgb.add shared (Rgb.scale rest alone))
  done

let sharp () =
  let s = scene [] in
  let lights = Area_lights.make s in
  let hit = Lit.hit s (0., 3., 9.) (0., 0., -1.) in
  Alcotest.(check (float 0.))
    "in full" 1.
    (Soft_shadows.weigh lights (Followed.path 0) hit);
  let dark = Lit.hit s (3., 5., 0.) (0., -1., 0.) in
  let from = Receiver.vantage (vertex s) in
  let path = Followed.path 0 in
  let arrival = Path.Spread { density = 1.; from } in
  let path = { path with journey = { path.journey with arrival } } in
  Alcotest.(check (float 0.))
    "no light" 1.
    (Soft_shadows.weigh lights path dark)

let calls () =
  let count forms = List.length (Soft_shadows.calls (Lit.scene forms)) in
  Alcotest.(check int) "a light and a floor" 1 (count [ floor; lamp () ]);
  Alcotest.(check int) "a floor" 0 (count [ floor ]);
  Alcotest.(check int) "nothing to shine on" 0 (count [ lamp () ]);
  Alcotest.(check int)
    "only a mirror" 0
    (count
       [ lamp (); "(sphere (center 0 0 0) (radius 1) (material (mirror)))" ])

let suite =
  ( "soft shadows",
    [
      Law.example "a ball of light shines by its closed form" lit;
      Law.example "one ray per point, and none where nothing can come" counted;
      Law.example "everything blocks light, glass too" blocked;
      Law.example "a light hides those behind it" other_light;
      Law.example "a veil takes its part" veiled;
      Law.example "light sampling and paths share each direction" shares;
      Law.example "what a camera or a mirror sees counts in full" sharp;
      Law.example "a light calls for it where its light can be seen" calls;
    ] )

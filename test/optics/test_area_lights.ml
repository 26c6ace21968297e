open Candor_space
open Candor_surface
open Candor_sample
open Candor_scene
open Candor_optics
open Candor_oracle
open Lit

let vantage ?(departure = Ray.Nowhere) ?(time = 0.) from =
  { Area_lights.from; departure; time }

(* The light that a point facing [normal] gets, by [n]² × [n] samples: the mean
   and its standard deviation. Only the light that was chosen counts, and where
   it is met first. *)
let irradiance ?(n = 24) ?(use = fun _ -> true) scene vantage (normal : Dir.t) =
  let lights = Area_lights.make scene in
  let surface = Assembly.surface ~dress:ignore scene in
  let sum = ref 0. and squares = ref 0. in
  let key = Random.State.make [| 7 |] in
  let within i =
    (float_of_int i +. Random.State.float key 1.) /. float_of_int n
  in
  for i = 0 to (n * n * n) - 1 do
    let choice = within (i mod n)
    and u = within (i / n mod n)
    and v = within (i / (n * n)) in
    match Area_lights.sample lights vantage ~choice { Pattern.u; v } with
    | None -> ()
    | Some { index; direction; density } -> (
        let again = Area_lights.density lights vantage ~index direction in
        Near.float ~within:1e-6 "density" 1. (again /. density);
        let ray =
          Ray.leaving vantage.departure vantage.from (direction :> Vec.t)
        in
        match Surface.nearest surface ~time:vantage.time ray with
        | Some hit
          when Area_lights.index lights hit.path = Some index && use hit ->
            let cosine = Float.max 0. (Dir.dot normal direction) in
            let light = (Area_lights.radiance lights index).r in
            let x = light *. cosine /. density in
            sum := !sum +. x;
            squares := !squares +. (x *. x)
        | Some _ | None -> ())
  done;
  let count = float_of_int (n * n * n) in
  let mean = !sum /. count in
  (mean, sqrt (((!squares /. count) -. (mean *. mean)) /. count))

(* Samples share the cube out, so that chance does no worse than this. *)
let check name expected (mean, deviation) =
  let allowed = (5. *. deviation) +. (1e-9 *. expected) in
  if not (Float.abs (mean -. expected) <= allowed) then
    Alcotest.failf "%s: %g, not %g; deviation %g" name mean expected deviation

let pi = Float.pi

(* The form factor of a sphere above the horizon is (r/d)² cos θ. *)
let from_ball (at : Point.t) (normal : Dir.t) center r =
  let way = Point.sub center at in
  let d = Vec.norm way in
  let cosine = Vec.dot (normal :> Vec.t) way /. d in
  pi *. (r /. d) *. (r /. d) *. cosine

let one_ball () =
  let center = p 0. 3. 0. and at = p 0.5 0. 1. in
  let scene = scene [ ball (glow 2.) center 1. ] in
  List.iter
    (fun normal ->
      check "a sphere"
        (2. *. from_ball at normal center 1.)
        (irradiance scene (vantage at) normal))
    [ dir 0. 1. 0.; dir 0.3 1. (-0.5) ];
  (* Looking straight at it, samples are the light up to their cosine. *)
  let _, deviation = irradiance scene (vantage at) (dir (-0.5) 3. (-1.)) in
  if deviation > 2e-3 then Alcotest.failf "a deviation of %g" deviation

(* The field of a square from above its middle: as W. Nusselt's analogue has it. *)
let square () =
  let h = 1.5 in
  let per_side = 1. /. sqrt ((h *. h) +. 1.) in
  let expected = 4. *. per_side *. Float.atan per_side in
  let plate = made (glow 1.) (Box (box (p (-1.) h (-1.)) (p 1. h 1.))) in
  check "a square" expected
    (irradiance (scene [ plate ]) (vantage Point.origin) (dir 0. 1. 0.))

let row n =
  List.init n (fun i ->
      let x = float_of_int (i mod 8) -. 3.7
      and z = float_of_int (i / 8) -. 3.1 in
      (p (1.1 *. x) 2. z, 0.1, 1. +. float_of_int (i mod 3)))

let many n () =
  let balls = row n in
  let at = p 0.1 0.2 0.3 and normal = dir 0. 1. 0. in
  let scene = scene (List.map (fun (c, r, k) -> ball (glow k) c r) balls) in
  let sum =
    List.fold_left
      (fun sum (c, r, k) -> sum +. (k *. from_ball at normal c r))
      0. balls
  in
  check "many spheres" sum (irradiance scene (vantage at) normal)

(* Bounded quadrics and squeezed spheres are found through their boxes. *)
let proxies () =
  let at = p 0.5 0. 1. and normal = dir 0. 1. 0. in
  let near = p 0.6 2.3 0.7 in
  let center = p 0. 3. 0. in
  let round =
    made (glow 1.)
      (Quadric (quadric (Ellipsoid { center; radii = Vec.v 1. 1. 1. })))
  and squeezed =
    moved
      [ Scale (Vec.v 1. 2. 1.); Translate (Vec.v 0. 3. 0.) ]
      [
        made (glow 1.)
          (Quadric
             (quadric
                (Ellipsoid { center = Point.origin; radii = Vec.v 1. 0.5 1. })));
      ]
  in
  List.iter
    (fun surface ->
      let scene = scene [ surface ] in
      check "a round quadric"
        (from_ball at normal center 1.)
        (irradiance scene (vantage at) normal);
      let facing = dir (-0.6) 0.7 (-0.7) in
      check "from inside its box"
        (from_ball near facing center 1.)
        (irradiance scene (vantage near) facing))
    [ round; squeezed ]

let motion () =
  let at = p 0.5 0. 1. and normal = dir 0. 1. 0. in
  let scene =
    scene
      [
        {
          (moved
             [ Rotate { axis = Vec.v 0. 1. 0.; degrees = 90. } ]
             [
               { (ball (glow 1.) (p 0. 3. 0.) 1.) with motion = Vec.v 0. 0. 2. };
             ])
          with
          motion = Vec.v 0. 1. 0.;
        };
      ]
  in
  List.iter
    (fun time ->
      let center = p (2. *. time) (3. +. time) 0. in
      check "where it stands"
        (from_ball at normal center 1.)
        (irradiance scene (vantage ~time at) normal))
    [ 0.; 0.5; 1. ]

(* What can be seen of smallpt's light, by the whole of it and by its cap: the
   same, the second with fewer samples. *)
let smallpt_light () =
  let at = p 60. 3. 90. and normal = dir 0. 1. 0. in
  let n = 26 in
  let mean, deviation = irradiance ~n smallpt (vantage at) normal in
  (* The cap is a disk but for its bulge, of 0.27 in 18. *)
  let lights = Area_lights.make smallpt in
  let disk =
    let h = 81.6 -. 3. and r = sqrt (2. *. 600. *. 0.27) in
    let aside = (10. *. 10.) +. (8.4 *. 8.4) in
    let s = (h *. h) +. aside +. (r *. r) in
    let past = s -. (2. *. r *. r) in
    0.5 *. (1. -. (past /. sqrt ((s *. s) -. (4. *. r *. r *. aside))))
  in
  Near.float ~within:0.02 "as of a disk" 1. (mean /. (12. *. pi *. disk));
  if deviation *. (float_of_int n ** 1.5) > 0.15 *. mean then
    Alcotest.failf "a deviation of %g of the mean"
      (deviation *. (float_of_int n ** 1.5) /. mean);
  (* The same by directions all around. *)
  let surface = Assembly.surface ~dress:ignore smallpt in
  let frame = Frame.of_dir normal in
  let k = 700 in
  let sum = ref 0. and whole = ref 0. in
  for i = 0 to (k * k) - 1 do
    let mid j = (float_of_int j +. 0.5) /. float_of_int k in
    let d = Spread.direction frame 0.3 (mid (i / k)) (mid (i mod k)) in
    whole := !whole +. Area_lights.density lights (vantage at) ~index:0 d;
    match Surface.nearest surface (Ray.v at (d :> Vec.t)) with
    | Some hit when Area_lights.index lights hit.path = Some 0 ->
        sum := !sum +. (12. *. Dir.dot normal d)
    | Some _ | None -> ()
  done;
  let each = 2. *. pi *. 0.3 /. float_of_int (k * k) in
  Near.float ~within:0.01 "directions" 1. (!sum *. each /. mean);
  Near.float ~within:0.01 "density" 1. (!whole *. each)

let hidden () =
  let plate y k = made (glow k) (Box (box (p (-1.) y (-1.)) (p 1. y 1.))) in
  let plane =
    made matte
      (Quadric (quadric (Plane { normal = Vec.v 0. 1. 0.; offset = 2. })))
  in
  let scene = scene [ plane; plate 1. 1.; plate 3. 100. ] in
  let lights = Area_lights.make scene in
  for i = 0 to 99 do
    let choice = float_of_int i /. 100. in
    match
      Area_lights.sample lights (vantage Point.origin) ~choice
        { u = 0.3; v = 0.4 }
    with
    | Some { index = 0; _ } -> ()
    | Some _ | None -> Alcotest.fail "what a wall hides is sampled"
  done;
  check "from the other side"
    (let s = 1. /. sqrt 2. in
     100. *. 4. *. s *. Float.atan s)
    (irradiance scene (vantage (p 0. 4. 0.)) (dir 0. (-1.) 0.))

let black () =
  let none = Area_lights.make (scene [ ball matte Point.origin 1. ]) in
  Alcotest.(check bool) "no light" true (Area_lights.is_empty none);
  let some =
    Area_lights.make
      (scene [ ball (glow 0.) Point.origin 1.; ball (glow 1.) (p 5. 0. 0.) 1. ])
  in
  Alcotest.(check (list (list int)))
    "paths" [ [ 1 ] ]
    (List.map (fun (e : Emitters.t) -> e.path) (Area_lights.emitters some));
  Alcotest.(check (option int))
    "its index" (Some 0)
    (Area_lights.index some [ 1 ]);
  Alcotest.(check (option int)) "no index" None (Area_lights.index some [ 0 ]);
  let is_at path = Area_lights.is_at some 0 path in
  Alcotest.(check (list bool))
    "is at its place alone"
    [ true; false; false; false ]
    (List.map is_at [ [ 1 ]; [ 0 ]; []; [ 1; 0 ] ]);
  Alcotest.(check bool) "no second light" false (Area_lights.is_at some 1 [ 1 ]);
  Alcotest.(check bool) "one is not chosen" false (Area_lights.chooses some);
  Near.rgb "no radiance" Candor_colour.Rgb.black (Area_lights.radiance some 1);
  Near.float "no density" 0.
    (Area_lights.density some (vantage Point.origin) ~index:1 Dir.x)

(* {1 Laws} *)

open QCheck2.Gen

(* A light as it is when all lengths are multiplied by a number. *)
let light =
  let* at = Draw.point (Draw.snapped (Draw.uniform (-4.) 4.)) in
  let+ kind = int_range 0 4
  and+ glowing = Draw.uniform 0.1 3.
  and+ both_sides = bool
  and+ motion = Draw.pick [ Vec.zero; Vec.v 1. 0.5 0. ] in
  fun k ->
    let place x y z =
      p (k *. (at.x +. x)) (k *. (at.y +. y)) (k *. (at.z +. z))
    in
    let at = place 0. 0. 0. in
    let shape =
      match kind with
      | 0 -> Scene.Sphere (sphere at (k *. 0.75))
      | 1 -> Box (box at (place 1. 0.5 2.))
      | 2 -> Triangle (triangle at (place 1. 0. 0.) (place 0. 0.5 1.))
      | 3 ->
          let radii = Vec.v k (0.5 *. k) k in
          Quadric (quadric (Ellipsoid { center = at; radii }))
      | _ ->
          let until = place 0. 1. 1. and radius = k *. 0.5 in
          Quadric (quadric (Cylinder { from = at; until; radius }))
    in
    { (made (glow glowing) shape) with both_sides; motion = Vec.scale k motion }

let case =
  let* n = oneof [ int_range 1 6; int_range 33 60 ] in
  let* lights = list_size (return n) light
  and* from = Draw.point (Draw.snapped (Draw.uniform (-5.) 5.))
  and* time = Draw.pick [ 0.; 0.5 ]
  and* choice = Draw.uniform 0.001 0.999
  and* u = Draw.uniform 0.001 0.999
  and* v = Draw.uniform 0.001 0.999 in
  return (lights, vantage ~time from, choice, { Pattern.u; v })

(* Behind a wall that hides some of them. *)
let among lights k =
  let plane =
    Quadric_shape.Plane { normal = Vec.v 0. 1. 0.5; offset = 3.5 *. k }
  in
  scene
    ~camera:(camera (p 0. 0. (2. *. k)) Point.origin)
    (made matte (Quadric (quadric plane))
    :: List.map (fun light -> light k) lights)

let show (lights, (at : Area_lights.vantage), choice, { Pattern.u; v }) =
  Printf.sprintf "%s\nfrom %s at %g, %h %h %h"
    (String.concat "\n"
       (List.map (fun light -> Scene.show_surface (light 1.)) lights))
    (Draw.show_point at.from) at.time choice u v

let agree (lights, vantage, choice, uv) =
  let lights = Area_lights.make (among lights 1.) in
  match Area_lights.sample lights vantage ~choice uv with
  | None -> true
  | Some { index; direction; density } ->
      let again = Area_lights.density lights vantage ~index direction in
      Near.close ~within:1e-9 (again /. density) 1.
      || Law.fail "%.17g, not %.17g" again density

(* All that a ray along any direction first meets has a density there, if it
   meets the emitting side. *)
let complete (lights, (vantage : Area_lights.vantage), _, uv) =
  let scene = among lights 1. in
  let lights = Area_lights.make scene in
  let surface = Assembly.surface ~dress:Fun.id scene in
  let d = Warp.sphere uv in
  match
    Surface.nearest surface ~time:vantage.time (Ray.v vantage.from (d :> Vec.t))
  with
  | None -> true
  | Some hit -> (
      match Area_lights.index lights hit.path with
      | None -> hit.path = [ 0 ] || Law.fail "no index"
      | Some index ->
          (hit.side = Inside && not hit.material.both_sides)
          || Area_lights.density lights vantage ~index d > 0.)

let same_when_scaled (lights, (vantage : Area_lights.vantage), choice, uv) =
  let scaled k =
    let all = Area_lights.make (among lights k) in
    let { Point.x; y; z } = vantage.from in
    let vantage = { vantage with from = p (k *. x) (k *. y) (k *. z) } in
    (all, vantage, Area_lights.sample all vantage ~choice uv)
  in
  let one, at, a = scaled 1. in
  List.for_all
    (fun e ->
      let other, at', b = scaled (Float.ldexp 1. e) in
      match (a, b) with
      | None, None -> true
      | Some { index; direction; density }, Some b ->
          index = b.index
          && same_dir direction b.direction
          && same_bits density b.density
          && same_bits
               (Area_lights.density one at ~index direction)
               (Area_lights.density other at' ~index direction)
      | None, Some _ | Some _, None -> false)
    [ -330; -3; 7; 330 ]

let suite =
  ( "area lights",
    [
      Law.example "a sphere lights as its closed form" one_ball;
      Law.example "a square lights as its closed form" square;
      Law.example "few spheres light as the sum of closed forms" (many 12);
      Law.example "many spheres light as the sum of closed forms" (many 64);
      Law.example "what is in a box lights as its closed form" proxies;
      Law.example "moving lights shine from where they are" motion;
      Law.example "smallpt's light is sampled where it shows" smallpt_light;
      Law.example "what a wall hides is not sampled" hidden;
      Law.example "what is black is no light" black;
      Law.law ~count:500 ~print:show
        "the density of a sample is that of its light and direction" case agree;
      Law.law ~count:2000 ~print:show
        "every light that a ray meets has a density there" case complete;
      Law.law ~count:300 ~print:show "scaling by 2^k leaves the bits" case
        same_when_scaled;
    ] )

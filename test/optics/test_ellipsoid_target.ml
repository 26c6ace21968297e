open Candor_space
open Candor_surface
open Candor_sample
open Candor_optics
open Candor_oracle
open Lit

let pi = Float.pi

type lamp = { target : Light_target.t; surface : unit Surface.t }
(** An emitting ellipsoid around 0: as a target, and as a surface. *)

let lamp ?transform ?(both_sides = false) x y z =
  let q = quadric (Ellipsoid { center = Point.origin; radii = Vec.v x y z }) in
  {
    target =
      Light_target.of_primitive (emitter ?transform ~both_sides (Quadric q));
    surface = Surface.seen_through ?transform (Surface.quadric q ());
  }

let skew =
  transform
    [
      Scale (Vec.v 1. 2. (-0.5));
      Rotate { axis = Vec.v 1. 1. 0.; degrees = 40. };
      Scale (Vec.v 1.5 0.4 1.);
    ]

let egg = lamp 1. 2. 0.5
let oblique = lamp ~transform:skew 1. 0.8 1.3
let disk = lamp 1. 1. 0.001
let leaf = lamp 1. 0.4 0.001
let needle = lamp 1. 0.001 0.001

let lamps =
  [
    ("egg", egg);
    ("round", lamp 1. 1. 1.);
    ("oblique", oblique);
    ("disk", disk);
    ("leaf", leaf);
    ("needle", needle);
  ]

(* {1 Densities} *)

let spread ?fine name lamp (from : Point.t) cone =
  let axis = dir (0.03 -. from.x) (0.02 -. from.y) (0.01 -. from.z) in
  let direction (s : Light_target.sample) = s.direction in
  Spread.check ?fine name ~axis ~one_minus_cos:cone
    ~sample:(fun u ->
      Option.map direction (Light_target.sample lamp.target ~from u))
    ~density:(Light_target.density lamp.target ~from)

let spreads () =
  spread "egg" egg (p 1. 2. 6.) 0.1;
  spread "egg, from near" egg (p 0.9 1.9 0.4) 2.;
  spread "egg, from its skin" egg (p 0. 0. 0.500001) 2.;
  spread "egg, from far" egg (p 1e5 2e5 3e5) 2e-11;
  spread ~fine:40 "oblique" oblique (p 3. 1. 2.) 0.6;
  spread ~fine:32 "oblique, from near" oblique (p 0.5 1. 0.7) 2.;
  spread ~fine:40 "disk" disk (p 0.3 0. 3.) 0.07;
  spread "disk, from near" disk (p 0.5 0.1 0.1) 2.;
  spread ~fine:40 "leaf, aslant" leaf (p 2. 1. 0.5) 0.2;
  spread "egg, from inside" (lamp ~both_sides:true 1. 2. 0.5) (p 0.2 0. 0.1) 2.

(* {1 Samples} *)

let fine = 400

let samples ?(n = fine) lamp from f =
  for i = 0 to (n * n) - 1 do
    let mid k = (float_of_int k +. 0.5) /. float_of_int n in
    f
      (Light_target.sample lamp.target ~from
         { u = mid (i / n); v = mid (i mod n) })
  done

let all_hit () =
  let hit name lamp from =
    samples ~n:60 lamp from (function
      | None ->
          Alcotest.failf "%s: no sample from %s" name (Draw.show_point from)
      | Some { Light_target.direction; _ } ->
          let ray = Ray.v from (direction :> Vec.t) in
          if not (Surface.blocked lamp.surface ~limit:infinity ray) then
            Alcotest.failf "%s is missed from %s" name (Draw.show_point from))
  in
  List.iter
    (fun (name, lamp) ->
      List.iter (hit name lamp)
        [ p 3. 4. 2.; p 0.5 3. 1.2; p 0.3 0.2 3.1; p 40. (-300.) 10. ])
    lamps

let inside () =
  let from = p 0.2 0.3 0.1 in
  let none t =
    Light_target.sample t ~from { u = 0.3; v = 0.4 } = None
    && Light_target.density t ~from Dir.x = 0.
    && Light_target.solid_angle t ~from = 0.
  in
  Alcotest.(check bool) "nothing inwards" true (none egg.target);
  Near.float "all around" (4. *. pi)
    (Light_target.solid_angle (lamp ~both_sides:true 1. 2. 0.5).target ~from)

(* {1 Solid angles} *)

(* Of a disk from above the middle, and of a spheroid from its axis. *)
let angles () =
  let angle lamp from = Light_target.solid_angle lamp.target ~from in
  let cone tangent = 2. *. pi *. (1. -. (1. /. sqrt (1. +. (tangent ** 2.)))) in
  let near = Near.float ~within:1e-12 in
  near "round" (cone (1. /. sqrt 8.)) (angle (lamp 1. 1. 1.) (p 2. 1. 2.));
  near "spheroid" (cone (1. /. sqrt 12.)) (angle (lamp 1. 1. 2.) (p 0. 0. 4.));
  near "stretched"
    (cone (1. /. sqrt 12.))
    (angle
       (lamp ~transform:(transform [ Scale (Vec.v 1. 2. 4.) ]) 1. 0.5 0.5)
       (p 0. 0. 4.));
  near "far, relative" 1. (angle egg (p 0. 0. 0x1p200) /. (2. *. pi *. 0x1p-400));
  Near.float ~within:0.05 "disk, next to it" (2. *. pi)
    (angle disk (p 0. 0. 0.01));
  List.iter
    (fun (name, lamp) ->
      let from = p 1. 2. 1. in
      let sum = ref 0. in
      samples lamp from
        (Option.iter (fun (s : Light_target.sample) ->
             sum := !sum +. (1. /. s.density)));
      let mean = !sum /. float_of_int (fine * fine) in
      Near.float ~within:5e-3 name 1. (mean /. angle lamp from))
    lamps

(* {1 Irradiance}

   Of a wall through [from]: over the samples, and over the lamp's own area, by
   the map from the unit ball. *)

type estimate = { mean : float; deviation : float (* of one, by the mean *) }

let irradiance lamp from normal =
  let sum = ref 0. and squares = ref 0. in
  samples lamp from
    (Option.iter (fun (s : Light_target.sample) ->
         let e = Float.max 0. (Dir.dot s.direction normal) /. s.density in
         sum := !sum +. e;
         squares := !squares +. (e *. e)));
  let count = float_of_int (fine * fine) in
  let mean = !sum /. count in
  {
    mean;
    deviation =
      sqrt (Float.max 0. ((!squares /. count) -. (mean *. mean))) /. mean;
  }

let by_area (r : Vec.t) (from : Point.t) normal =
  let m = 1000 in
  let sum = ref 0. in
  for i = 0 to m - 1 do
    let cosine = (2. *. (float_of_int i +. 0.5) /. float_of_int m) -. 1. in
    let sine = sqrt (1. -. (cosine *. cosine)) in
    for j = 0 to m - 1 do
      let a = 2. *. pi *. (float_of_int j +. 0.5) /. float_of_int m in
      let e = Vec.v (sine *. cos a) (sine *. sin a) cosine in
      let at = p (r.x *. e.x) (r.y *. e.y) (r.z *. e.z)
      and area =
        Vec.v (r.y *. r.z *. e.x) (r.z *. r.x *. e.y) (r.x *. r.y *. e.z)
      in
      let way = Point.sub at from in
      let d2 = Vec.dot way way in
      let facing = -.Vec.dot way area
      and down = Vec.dot way (normal : Dir.t :> Vec.t) in
      if facing > 0. && down > 0. then
        sum := !sum +. (facing *. down /. (d2 *. d2))
    done
  done;
  !sum *. 4. *. pi /. float_of_int (m * m)

let walls =
  [
    ("egg", egg, Vec.v 1. 2. 0.5, p 0. 0. (-2.), Dir.z, 0.1);
    ("egg, aside", egg, Vec.v 1. 2. 0.5, p 3. 1. (-2.), Dir.z, 0.18);
    ("egg, from near", egg, Vec.v 1. 2. 0.5, p 0.3 0.2 (-0.6), Dir.z, 0.4);
    ("disk", disk, Vec.v 1. 1. 0.001, p 0. 0. (-2.), Dir.z, 0.1);
    ("disk, from near", disk, Vec.v 1. 1. 0.001, p 0.5 0. (-0.1), Dir.z, 0.5);
    ("leaf", leaf, Vec.v 1. 0.4 0.001, p 0.5 0. (-0.5), Dir.z, 0.25);
    ("needle", needle, Vec.v 1. 0.001 0.001, p 0. 0. (-0.1), Dir.z, 0.3);
  ]

let walls_lit () =
  List.iter
    (fun (name, lamp, radii, from, normal, most) ->
      let { mean; deviation } = irradiance lamp from normal in
      Near.float ~within:0.008 name 1. (mean /. by_area radii from normal);
      if deviation > most then
        Alcotest.failf "%s: %g by the mean and sample" name deviation)
    walls

(* {1 Laws} *)

open QCheck2.Gen

let view =
  let* name, lamp = Draw.pick lamps in
  let* from =
    oneof
      [
        Draw.point (Draw.uniform (-3.) 3.);
        Draw.point (Draw.signed (Draw.wide (-3.) 3.));
      ]
  in
  let* u = Draw.uniform 0.001 0.999 and* v = Draw.uniform 0.001 0.999 in
  return (name, lamp, from, { Pattern.u; v })

let show (name, _, from, { Pattern.u; v }) =
  Printf.sprintf "%s from %s at %h %h" name (Draw.show_point from) u v

let agree (_, { target; _ }, from, p) =
  match Light_target.sample target ~from p with
  | None -> Light_target.solid_angle target ~from = 0.
  | Some { direction; density } ->
      let again = Light_target.density target ~from direction in
      Float.abs (again -. density) <= 1e-6 *. density
      || Law.fail "%.17g, not %.17g" again density

let scaling =
  let* radii = Draw.pick [ Vec.v 1. 2. 0.5; Vec.v 1. 1. 0.001 ] in
  let* transform = Draw.pick [ None; Some skew ]
  and* e = int_range (-350) 350
  and* _, _, from, uv = view in
  return (radii, transform, e, from, uv)

let show_scaling (radii, _, e, from, { Pattern.u; v }) =
  Printf.sprintf "%s times 2^%d from %s at %h %h" (Vec.show radii) e
    (Draw.show_point from) u v

let same_when_scaled ((radii : Vec.t), transform, e, from, uv) =
  let one = (lamp ?transform radii.x radii.y radii.z).target in
  let r = Vec.ldexp e radii and from' = Point.ldexp e from in
  let other = (lamp ?transform r.x r.y r.z).target in
  same_bits
    (Light_target.solid_angle one ~from)
    (Light_target.solid_angle other ~from:from')
  &&
  match
    (Light_target.sample one ~from uv, Light_target.sample other ~from:from' uv)
  with
  | None, None -> true
  | Some a, Some b ->
      same_dir a.direction b.direction
      && same_bits a.density b.density
      && same_bits
           (Light_target.density one ~from a.direction)
           (Light_target.density other ~from:from' a.direction)
  | None, Some _ | Some _, None -> false

let suite =
  ( "ellipsoid target",
    [
      Law.example "directions are spread as their density says" spreads;
      Law.example "every sample meets the ellipsoid" all_hit;
      Law.example "from inside, one side shows nothing" inside;
      Law.example "solid angles are those of closed forms" angles;
      Law.example "walls are lit as by the ellipsoid's own area" walls_lit;
      Law.law ~print:show "the density of a sample is that of its direction"
        view agree;
      Law.law ~print:show_scaling "scaling by 2^k leaves the bits" scaling
        same_when_scaled;
    ] )

open Candor_space
open Candor_colour
open Candor_surface
open Candor_effect
open Candor_oracle
open QCheck2

let mirror ?(extra = "") color =
  Lit.scene
    [
      Printf.sprintf "(box (min -9 -9 0) (max 9 9 0) (material %s) %s)" color
        extra;
    ]

let half = "(mirror (color (rgb .5 .25 0)))"

(* What the term makes of a ray from (1, 2, 3) along [d], the recursion
   answering 1, and the rays it followed. *)
let run ?(depth = 8) ?(cutoff = 0.) ?path ?(color = half) d =
  let s = mirror color in
  let followed = ref [] in
  let radiance _ ~kind path ray =
    followed := (kind, path, ray) :: !followed;
    Rgb.white
  in
  let tally = Tally.make () in
  let hit = Lit.hit s (1., 2., 3.) d in
  let view = Vec.neg (Lit.ray (1., 2., 3.) d).direction in
  let value =
    Mirror.term
      (Limit.Fixed { depth; cutoff })
      radiance tally
      (Lit.vertex ?path hit view)
  in
  (value, !followed, tally)

let counts t = Tally.(get t Mirror_rays, get t Cut_by_depth, get t Cut_by_weight)

let check_counts name expected t =
  Alcotest.(check (triple int int int)) name expected (counts t)

let slanting = (1., 0.5, -1.5)

let reflects () =
  let value, followed, tally = run slanting in
  Alcotest.check Lit.rgb "the mirror's share" (Rgb.v 0.5 0.25 0.) value;
  check_counts "one ray" (1, 0, 0) tally;
  match followed with
  | [ (kind, path, ray) ] ->
      Alcotest.(check string) "its kind" "mirror" kind;
      Alcotest.(check int) "its depth" 1 path.Path.depth;
      Alcotest.check Lit.rgb "its throughput" (Rgb.v 0.5 0.25 0.)
        path.throughput;
      Alcotest.(check bool)
        "its direction" true
        (Vec.equal ray.Ray.direction (Vec.v 1. 0.5 1.5));
      Alcotest.(check bool)
        "it remembers the surface" true (ray.departure <> Nowhere)
  | _ -> Alcotest.fail "expected one ray"

let no_mirror () =
  let value, followed, tally = run ~color:"(matte (color 1))" slanting in
  Alcotest.check Lit.rgb "nothing" Rgb.black value;
  Alcotest.(check int) "no ray" 0 (List.length followed);
  check_counts "nothing is cut either" (0, 0, 0) tally;
  let _, _, tally = run ~depth:0 ~color:"(matte (color 1))" slanting in
  check_counts "not even at depth 0" (0, 0, 0) tally

let glazed () =
  let value, _, _ =
    run ~color:"(glazed (color .3) (mirror (rgb .5 .125 0)))" slanting
  in
  Alcotest.check Lit.rgb "not multiplied by the colour" (Rgb.v 0.5 0.125 0.)
    value

let cut_by_depth () =
  let path depth = { Path.start with depth } in
  let value, followed, tally = run ~depth:3 ~path:(path 3) slanting in
  Alcotest.check Lit.rgb "nothing" Rgb.black value;
  Alcotest.(check int) "no ray" 0 (List.length followed);
  check_counts "counted" (0, 1, 0) tally;
  let _, followed, tally = run ~depth:3 ~path:(path 2) slanting in
  check_counts "the last one" (1, 0, 0) tally;
  Alcotest.(check (list int))
    "at its depth" [ 3 ]
    (List.map (fun (_, p, _) -> p.Path.depth) followed)

let cut_by_weight () =
  let path = { Path.start with throughput = Rgb.grey 0.5 } in
  let _, _, tally = run ~cutoff:0.25 ~path slanting in
  check_counts "at the cut-off" (1, 0, 0) tally;
  let value, _, tally = run ~cutoff:(Float.succ 0.25) ~path slanting in
  check_counts "below it" (0, 0, 1) tally;
  Alcotest.check Lit.rgb "nothing" Rgb.black value;
  let _, _, tally = run ~cutoff:0.9 ~depth:0 slanting in
  check_counts "counted once" (0, 1, 0) tally

let cuts_are_shown () =
  let cut ~depth ~cutoff =
    let s = mirror half in
    let seen = ref [] in
    let tally = Tally.make ~watch:(fun e -> seen := e :: !seen) () in
    let vertex =
      Lit.vertex (Lit.hit s (1., 2., 3.) slanting) (Vec.v (-1.) (-0.5) 1.5)
    in
    ignore
      (Mirror.term (Limit.Fixed { depth; cutoff }) Lit.no_recursion tally vertex
        : Rgb.t);
    !seen
  in
  (match cut ~depth:0 ~cutoff:0. with
  | [ Cut Depth ] -> ()
  | _ -> Alcotest.fail "expected a cut by depth");
  match cut ~depth:1 ~cutoff:0.9 with
  | [ Cut Weight ] -> ()
  | _ -> Alcotest.fail "expected a cut by weight"

(* The reflected ray, from a ball seen along any line. *)
let law_of_reflection =
  let gen =
    Gen.triple Draw.unit (Draw.uniform (-0.9) 0.9) (Draw.uniform (-0.9) 0.9)
  in
  let print (d, x, y) = Printf.sprintf "%s %g %g" (Draw.show_vec d) x y in
  let s =
    Lit.scene [ "(sphere (center 0 0 0) (radius 2) (material (mirror)))" ]
  in
  Law.law ~print "r = 2(n.v)n - v: equal angles, one plane, and outwards" gen
    (fun (d, x, y) ->
      let o = Point.add (Point.v x y 0.5) (Vec.scale (-20.) d) in
      let hit = Lit.hit s (o.x, o.y, o.z) (d.x, d.y, d.z) in
      let got = ref Vec.zero in
      let radiance _ ~kind:_ _ (ray : Ray.t) =
        got := ray.direction;
        Rgb.black
      in
      ignore
        (Mirror.term
           (Limit.Fixed { depth = 1; cutoff = 0. })
           radiance (Tally.make ())
           (Lit.vertex hit (Vec.neg d))
          : Rgb.t);
      let n = (hit.normal :> Vec.t) and r = !got in
      Lit.close ~within:1e-14 (Vec.dot n r) (-.Vec.dot n d)
      && Vec.largest (Vec.sub (Vec.cross n r) (Vec.cross n d)) < 1e-14
      && Vec.dot n r > 0.
      && Surface.nearest (Candor_optics.Skin.surface s) (Hit.spawn hit r) = None)

(* Where a bent normal would send the reflection into the surface, the true one
   is used. *)
let bent () =
  let reflected normal d =
    let s =
      Lit.scene
        [
          Printf.sprintf
            "(triangle (-9 -9 0) (9 -9 0) (0 9 0) (normals %s %s %s) (material \
             (mirror)))"
            normal normal normal;
        ]
    in
    let got = ref Vec.zero in
    let radiance _ ~kind:_ _ (ray : Ray.t) =
      got := ray.direction;
      Rgb.black
    in
    let hit = Lit.hit s (-1., 0., 3.) d in
    let view = Vec.neg (Lit.ray (0., 0., 0.) d).direction in
    let vertex = Lit.vertex hit view in
    ignore
      (Mirror.term
         (Limit.Fixed { depth = 1; cutoff = 0. })
         radiance (Tally.make ()) vertex
        : Rgb.t);
    !got
  in
  Alcotest.(check bool)
    "as a flat mirror, where it must be" true
    (Vec.equal (reflected "(9 0 1)" (0.1, 0., -1.)) (Vec.v 0.1 0. 1.));
  let aside = reflected "(1 0 2)" (0., 0., -1.) in
  Lit.check_close "bent where it may be" (Rgb.v 0.8 0. 0.6)
    (Rgb.v aside.x aside.y aside.z)

let suite =
  ( "mirror",
    [
      Law.example "a mirror follows one ray and takes its share" reflects;
      Law.example "what does not reflect follows none and cuts none" no_mirror;
      Law.example "a glaze reflects M, whatever its colour" glazed;
      Law.example "paths end at their depth, and are counted" cut_by_depth;
      Law.example "paths end below the cut-off, and are counted" cut_by_weight;
      Law.example "watchers see why a path was cut" cuts_are_shown;
      law_of_reflection;
      Law.example "interpolated normals never reflect into the surface" bent;
    ] )

open Candor_space
open Candor_colour
open Candor_optics
open Candor_effect
open Candor_oracle

let floor material =
  Lit.scene [ "(box (min -9 -1 -9) (max 9 0 9) (material " ^ material ^ "))" ]

let matte = "(matte (color (rgb .5 .25 0)))"
let unlimited = Limit.Roulette { depth = max_int }

let vertex material =
  Followed.vertex (floor material) (3., 2., 1.) (-3., -2., -1.)

let run_at ?answer ?(limit = unlimited) ?(path = Path.start) vertex =
  Followed.v ?answer
    (Indirect.term Scattering.glossy limit)
    { vertex with Term.path }

let run ?limit ?path material = run_at ?limit ?path (vertex material)

let follows () =
  for i = 0 to 99 do
    let f = run ~path:(Followed.path i) matte in
    Lit.check_close "its colour" (Rgb.v 0.5 0.25 0.) f.value;
    Alcotest.(check int) "counted" 1 (Tally.get f.tally Bounce_rays);
    match f.rays with
    | [ { kind; path; ray } ] -> (
        Alcotest.(check string) "kind" "bounce" kind;
        Alcotest.(check int) "depth" 1 path.depth;
        Lit.check_close "throughput" (Rgb.v 0.5 0.25 0.) path.throughput;
        let cos = ray.direction.y /. Vec.norm ray.direction in
        Alcotest.(check bool) "upwards" true (cos > 0.);
        match path.journey.arrival with
        | Spread { density; from } ->
            Alcotest.(check (float 1e-12))
              "as dense as cos/pi" (cos /. Float.pi) density;
            Alcotest.(check bool)
              "from there" true
              (Vec.norm (Point.sub from.from Point.origin) < 1e-9)
        | Sharp -> Alcotest.fail "it was chosen by chance")
    | _ -> Alcotest.fail "expected one ray"
  done

(* Under a sky of y: ∫ cos y / π = 2/3 of the colour. *)
let estimates () =
  let answer (r : Followed.ray) =
    Rgb.grey (r.ray.direction.y /. Vec.norm r.ray.direction)
  in
  let vertex = vertex matte in
  let value =
    Followed.mean 20_000 (fun path -> (run_at ~answer ~path vertex).value)
  in
  Lit.check_close ~within:5e-3 "the integral"
    (Rgb.scale (2. /. 3.) (Rgb.v 0.5 0.25 0.))
    value

let nothing () =
  let check name ?limit ?path material cut =
    let f = run ?limit ?path material in
    Alcotest.check Lit.rgb name Rgb.black f.value;
    Alcotest.(check int) (name ^ ", rays") 0 (List.length f.rays);
    Alcotest.(check int) (name ^ ", cut") cut (Tally.get f.tally Cut_by_depth)
  in
  check "black" "(matte (color 0))" 0;
  check "a mirror" "(mirror)" 0;
  check "glass" "(glass (index 1.5))" 0;
  check "at once" ~limit:At_once matte 0;
  check "at its depth" ~limit:(Roulette { depth = 0 }) matte 1

(* A glaze competes with what is under it: both are right in the mean. *)
let glazed () =
  let material = "(glazed (color .25) (mirror .5))" in
  let followed = ref 0 and vertex = vertex material in
  let value =
    Followed.mean 20_000 (fun path ->
        let f = run_at ~path vertex in
        followed := !followed + List.length f.rays;
        f.value)
  in
  Lit.check_close ~within:0.02 "its colour" (Rgb.grey 0.25) value;
  Alcotest.(check bool)
    "by a third of the paths" true
    (abs (!followed - 6667) < 350)

let mirror_shares material expected =
  let vertex = Followed.vertex (floor material) (0., 2., 0.) (0., -1., 0.) in
  let rays = ref 0 in
  let value =
    Followed.mean 20_000 (fun path ->
        let vertex = { vertex with path } in
        let one = Followed.v (Mirror.term unlimited) vertex
        and other =
          Followed.v (Indirect.term Scattering.glossy unlimited) vertex
        in
        rays := !rays + List.length one.rays + List.length other.rays;
        Rgb.add one.value other.value)
  in
  Lit.check_close ~within:0.03 material expected value;
  if !rays > 20_700 then Alcotest.failf "%s: %d rays" material !rays

let shares () =
  mirror_shares "(glazed (color .25) (mirror .5))" (Rgb.grey 0.75);
  mirror_shares "(plastic (color 1) (index 1.5) (roughness 0))" Rgb.white

let calls () =
  let count forms = List.length (Indirect.calls (Lit.scene forms)) in
  let ball material =
    "(sphere (center 0 0 0) (radius 1) (material " ^ material ^ "))"
  in
  Alcotest.(check int)
    "matte" 1
    (count [ "(indirect-light)"; ball "(matte (color .5))" ]);
  Alcotest.(check int)
    "rough metal" 1
    (count
       [ "(indirect-light)"; ball "(metal (reflectance 1) (roughness .1))" ]);
  Alcotest.(check int)
    "nothing that spreads light" 0
    (count [ "(indirect-light)"; ball "(mirror)" ]);
  Alcotest.(check int) "not asked for" 0 (count [ ball "(matte (color .5))" ])

let suite =
  ( "indirect light",
    [
      Law.example "one ray is followed, by the cosine, and takes the colour"
        follows;
      Law.example "the mean is the integral over the hemisphere" estimates;
      Law.example "nothing is followed where nothing is spread" nothing;
      Law.example "a glaze takes its share of the paths" glazed;
      Law.example "mirror and base together send on one path" shares;
      Law.example "it is called for where it can be seen" calls;
    ] )

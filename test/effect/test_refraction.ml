open Candor_space
open Candor_colour
open Candor_effect
open Candor_oracle
open QCheck2

let glass ?(index = 1.5) ?(more = "") () =
  Lit.scene
    [
      Printf.sprintf
        "(box (min -9 -9 -2) (max 9 9 0) (material (glass (index %g) %s)))"
        index more;
    ]

let fixed = Limit.Fixed { depth = 8; cutoff = 0. }

let run ?(limit = fixed) ?(splits = max_int) ?path ?answer scene o d =
  Followed.v ?answer
    (Refraction.term Refraction.index ~splits limit (Lit.tracer scene))
    (Followed.vertex ?path scene o d)

let inside (r : Followed.ray) = List.length r.path.journey.inside
let up (r : Followed.ray) = r.ray.direction.z > 0.

(* Straight on: R = (n - 1)²/(n + 1)². *)
let both () =
  let f =
    run (glass ~more:"(color (rgb 1 .5 0))" ()) (0., 0., 3.) (0., 0., -2.)
  in
  Lit.check_close "all of it, coloured" (Rgb.v 1. 0.5 0.) f.value;
  Alcotest.(check int) "rays" 2 (Tally.get f.tally Refraction_rays);
  match f.rays with
  | [ back; on ] ->
      Alcotest.(check (pair bool bool)) "ways" (true, false) (up back, up on);
      Alcotest.(check (pair int int)) "inside" (0, 1) (inside back, inside on);
      Lit.check_close "reflected" (Rgb.v 0.04 0.02 0.) back.path.throughput;
      Lit.check_close "transmitted" (Rgb.v 0.96 0.48 0.) on.path.throughput;
      Alcotest.(check (pair int int))
        "depth" (1, 1)
        (back.path.depth, on.path.depth);
      Alcotest.(check string) "kind" "refraction" on.kind;
      Alcotest.(check bool) "keys" true (back.path.key <> on.path.key)
  | _ -> Alcotest.fail "expected two rays"

let matched () =
  let f = run (glass ~index:1. ()) (0., 0., 3.) (1., 0., -2.) in
  Alcotest.(check int) "nothing is reflected" 1 (List.length f.rays);
  Alcotest.check Lit.rgb "all goes through" Rgb.white f.value

let snell =
  let gen = Gen.pair (Draw.uniform 0. 1.5) (Draw.pick [ 1.5; 0.75; 2.4 ]) in
  let print (a, n) = Printf.sprintf "%g into %g" a n in
  Law.law ~count:500 ~print "sines go by the indices, and nothing is lost" gen
    (fun (angle, n) ->
      let d = (sin angle, 0., -.cos angle) in
      let f = run (glass ~index:n ()) (0., 0., 0.25) d in
      let bent (r : Followed.ray) =
        r.ray.direction.x /. Vec.norm r.ray.direction
      in
      Lit.close_rgb f.value Rgb.white
      &&
      match f.rays with
      | [ back; on ] ->
          up back
          && (not (up on))
          && Lit.close ~within:1e-12 (bent on *. n) (sin angle)
          && Lit.close ~within:1e-12 (bent back) (sin angle)
      | [ back ] -> up back && sin angle >= n *. (1. -. 1e-12)
      | _ -> false)

let total () =
  let s = glass () in
  let m = (Lit.hit s (0., 0., 3.) (0., 0., -1.)).material.material in
  let path = Followed.path ~inside:[ m ] 0 in
  let f = run ~path s (0., 0., -1.) (1., 0., 0.5) in
  Alcotest.(check int) "one ray" 1 (List.length f.rays);
  let r = List.hd f.rays in
  Alcotest.(check bool) "back" false (up r);
  Alcotest.(check int) "still inside" 1 (inside r);
  Lit.check_close "all of it" Rgb.white f.value

(* A ray that comes from inside without having entered was inside. *)
let unentered () =
  let f = run (glass ()) (0., 0., -1.) (0., 0., 1.) in
  Alcotest.(check (list int)) "in and out" [ 1; 0 ] (List.map inside f.rays)

let stacks () =
  let s = glass () and other = glass ~index:1.33 () in
  let material s = (Lit.hit s (0., 0., 3.) (0., 0., -1.)).material.material in
  let m = material s and w = material other in
  let after ~inside o d =
    let path = Followed.path ~inside 0 in
    List.map
      (fun (r : Followed.ray) -> r.path.journey.inside)
      (run ~path s o d).rays
  in
  let same = Alcotest.(check bool) in
  same "into glass from water" true
    (after ~inside:[ w ] (0., 0., 3.) (0., 0., -1.) = [ [ w ]; [ m; w ] ]);
  same "out of glass into water" true
    (after ~inside:[ m; w ] (0., 0., -1.) (0., 0., 1.) = [ [ m; w ]; [ w ] ]);
  same "glass left while in water bends nothing" true
    (after ~inside:[ w; m ] (0., 0., -1.) (1., 0., 1.) = [ [ w ] ]);
  same "glass twice around" true
    (after ~inside:[ m; m ] (0., 0., -1.) (1., 0., 1.) = [ [ m ] ])

let without () =
  let m i =
    Candor_scene.Material.v
      (Glass
         {
           index = i;
           color = Constant Rgb.white;
           absorption = Rgb.black;
           dispersion = None;
         })
  in
  let a = m 1. and b = m 2. and twin = m 1. in
  let check name expected l =
    Alcotest.(check bool) name true (List.equal ( == ) expected l)
  in
  check "the first" [ b; a ] (Refraction.without a [ a; b; a ]);
  check "further down" [ b ] (Refraction.without a [ b; a ]);
  check "another that looks the same" [ twin ] (Refraction.without a [ twin ]);
  check "none" [] (Refraction.without a [])

(* One of both by chance, in proportion to their shares. *)
let by_chance () =
  let n = 4000 in
  let s = glass ~index:3. () in
  let reflected =
    List.init n (fun i ->
        let f =
          run ~splits:0 ~path:(Followed.path i) s (0., 0., 3.) (0., 0., -1.)
        in
        Alcotest.(check int) "one ray" 1 (List.length f.rays);
        Alcotest.check Lit.rgb "in full" Rgb.white f.value;
        up (List.hd f.rays))
    |> List.filter Fun.id |> List.length
  in
  let z =
    (float_of_int reflected -. (0.25 *. float_of_int n))
    /. sqrt (float_of_int n *. 0.25 *. 0.75)
  in
  if Float.abs z > 5. then Alcotest.failf "%d reflections, z = %g" reflected z

let ends () =
  let run limit = run ~limit (glass ()) (0., 0., 3.) (0., 0., -1.) in
  let f = run (Fixed { depth = 0; cutoff = 0. }) in
  Alcotest.(check int) "by depth" 2 (Tally.get f.tally Cut_by_depth);
  Alcotest.(check int) "no ray" 0 (Tally.get f.tally Refraction_rays);
  let f = run (Fixed { depth = 1; cutoff = 0.5 }) in
  Alcotest.(check int) "by weight" 1 (Tally.get f.tally Cut_by_weight);
  Alcotest.(check int) "one ray" 1 (Tally.get f.tally Refraction_rays)

let opaque () =
  let s =
    Lit.scene [ "(box (min -9 -9 -2) (max 9 9 0) (material (mirror)))" ]
  in
  let f = run s (0., 0., 3.) (0., 0., -1.) in
  Alcotest.check Lit.rgb "nothing" Rgb.black f.value;
  Alcotest.(check int) "no ray" 0 (List.length f.rays)

(* A normal that is bent too far does not let light through the wrong way. *)
let bent_normals () =
  let s =
    Lit.scene
      [
        "(triangle (-9 -9 0) (9 -9 0) (0 9 0) (normals (9 0 1) (9 0 1) (9 0 \
         1)) (material (glass (index 1.5))))";
      ]
  in
  List.iter
    (fun x ->
      let f = run s (0., 0., 1.) (x, 0., -1.) in
      List.iter
        (fun (r : Followed.ray) ->
          let beyond = inside r = 1 in
          Alcotest.(check bool) "on the right side" beyond (not (up r)))
        f.rays)
    [ 0.; 0.5; 2.; -0.5; -2. ]

let calls () =
  let count text =
    List.length
      (Refraction.calls
         (Lit.scene
            [ "(sphere (center 0 0 0) (radius 1) (material " ^ text ^ "))" ]))
  in
  List.iter
    (fun (text, expected) -> Alcotest.(check int) text expected (count text))
    [
      ("(glass (index 1))", 1);
      ("(translucent (index 1.5) (scattering 1) (absorption 1))", 1);
      ("(mirror)", 0);
      ("(plastic (color 1) (index 1.5) (roughness 0))", 0);
    ]

let suite =
  ( "refraction",
    [
      Law.example "glass follows both ways with their shares" both;
      Law.example "glass of index 1 reflects nothing and follows one ray"
        matched;
      snell;
      Law.example "total reflection follows one ray" total;
      Law.example "a ray that leaves what it did not enter was inside" unentered;
      Law.example "bodies are left in any order" stacks;
      Law.example "a body is told by its identity" without;
      Law.example "one way by chance, as often as its share" by_chance;
      Law.example "paths end at a limit, each branch by itself" ends;
      Law.example "what lets nothing through follows nothing" opaque;
      Law.example "interpolated normals send nothing to the wrong side"
        bent_normals;
      Law.example "glass and translucent bodies call for it" calls;
    ] )

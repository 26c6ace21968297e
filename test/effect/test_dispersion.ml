open Candor_space
open Candor_colour
open Candor_effect
open Candor_oracle
open Candor_scene_made
open QCheck2

let close = Alcotest.(check (float 1e-12))

(* {1 Indices} *)

let index_law =
  let gen = Gen.pair (Draw.uniform 1.3 2.) (Draw.uniform 15. 90.) in
  let print (n, v) = Printf.sprintf "%g, Abbe %g" n v in
  Law.law ~print "the index has its Abbe number, and falls with wavelength" gen
    (fun (index, abbe) ->
      let n = Dispersion.index_at ~index ~abbe in
      let v = (n 587.6 -. 1.) /. (n 486.1 -. n 656.3) in
      Lit.close (n 587.6) index
      && Lit.close ~within:1e-10 v abbe
      && n 400. > n 500.
      && n 500. > n 600.
      && n 600. > n 700.)

let plain_index () =
  let n = Dispersion.index_at ~index:1.5 ~abbe:1e18 in
  List.iter
    (fun l -> Alcotest.(check (float 1e-15)) "without dispersion" 1.5 (n l))
    [ 380.; 500.; 720. ];
  let wild = Dispersion.index_at ~index:1.5 ~abbe:1e-3 720. in
  Alcotest.(check bool) "never 0 or below" true (wild > 0.)

(* {1 Colours} *)

let white () =
  let n = 4096 in
  let sum =
    List.init n (fun i ->
        Dispersion.(
          colour (wavelength ((float_of_int i +. 0.5) /. float_of_int n))))
    |> List.fold_left Rgb.add Rgb.black
  in
  Lit.check_close ~within:1e-4 "in the mean" Rgb.white
    (Rgb.scale (1. /. float_of_int n) sum);
  close "from" 380. (Dispersion.wavelength 0.);
  close "up to" 550. (Dispersion.wavelength 0.5)

let colours () =
  let largest l = Dispersion.colour l in
  let blue = largest 450. and green = largest 530. and red = largest 640. in
  Alcotest.(check bool) "450 is blue" true (blue.b > blue.r && blue.b > blue.g);
  Alcotest.(check bool)
    "530 is green" true
    (green.g > green.r && green.g > green.b);
  Alcotest.(check bool) "640 is red" true (red.r > red.g && red.r > red.b)

(* {1 Paths} *)

let glass more =
  Lit.scene
    [
      "(box (min -9 -9 -2) (max 9 9 0) (material (glass (index 1.5) " ^ more
      ^ ")))";
    ]

let limit = Limit.Fixed { depth = 8; cutoff = 0. }

let run ?path scene d =
  let term =
    Dispersion.term (fun index ->
        Refraction.term index ~splits:max_int limit (Lit.tracer scene))
  in
  Followed.v term (Followed.vertex ?path scene (0., 0., 3.) d)

let slanting = (1., 0., -1.)

let snell () =
  for i = 0 to 99 do
    let f = run ~path:(Followed.path i) (glass "(dispersion 20)") slanting in
    match f.rays with
    | [ back; on ] ->
        let wavelength (r : Followed.ray) = r.path.journey.wavelength in
        Alcotest.(check (option (float 0.)))
          "one for both" (wavelength back) (wavelength on);
        let l = Option.get (wavelength on) in
        let n = Dispersion.index_at ~index:1.5 ~abbe:20. l in
        let d = on.ray.direction in
        close "bent by its index" (sqrt 0.5) (n *. d.x /. Vec.norm d);
        Lit.check_close ~within:1e-12 "of its colour" (Dispersion.colour l)
          f.value;
        Lit.check_close ~within:1e-12 "which the paths carry"
          (Dispersion.colour l)
          (Rgb.add back.path.throughput on.path.throughput)
    | _ -> Alcotest.fail "expected two rays"
  done

(* The bluer the light the more it turns. *)
let order () =
  let bent =
    List.init 50 (fun i ->
        let f =
          run ~path:(Followed.path i) (glass "(dispersion 30)") slanting
        in
        let on = List.nth f.rays 1 in
        (Option.get on.path.journey.wavelength, on.ray.direction.x))
    |> List.sort compare |> List.map snd
  in
  Alcotest.(check bool) "in order" true (List.sort compare bent = bent)

let keeps_its_own () =
  let path = Followed.path 3 in
  let path =
    { path with journey = { path.journey with wavelength = Some 500. } }
  in
  let f = run ~path (glass "(dispersion 20)") slanting in
  Lit.check_close "no second colour" Rgb.white f.value;
  List.iter
    (fun (r : Followed.ray) ->
      Alcotest.(check (option (float 0.)))
        "the same" (Some 500.) r.path.journey.wavelength)
    f.rays

let none_needed () =
  let f = run ~path:(Followed.path 3) (glass "") slanting in
  Lit.check_close "no colour" Rgb.white f.value;
  List.iter
    (fun (r : Followed.ray) ->
      Alcotest.(check (option (float 0.))) "none" None r.path.journey.wavelength)
    f.rays

(* Light of a camera in such glass meets a bubble first. *)
let in_dispersive () =
  let m = (Lit.hit (glass "(dispersion 20)") (0., 0., 3.) slanting).material in
  let path = Followed.path ~inside:[ m.material ] 3 in
  let f = run ~path (glass "") slanting in
  List.iter
    (fun (r : Followed.ray) ->
      Alcotest.(check bool)
        "one is chosen" true
        (Option.is_some r.path.journey.wavelength))
    f.rays

(* {1 Pictures} *)

let forms more =
  [
    Written.size 8 6;
    Written.flat_camera;
    "(background (gradient (down (rgb .1 .2 .3)) (up (rgb .9 .7 .4))))";
    "(render (spp 16))";
    "(sphere (center -.6 0 0) (radius .3) (material (glass (index 1.5))))";
  ]
  @ more

let unmet () =
  let far dispersion =
    Printf.sprintf
      "(sphere (center 0 0 50) (radius 1) (material (glass (index 1.5) %s)))"
      dispersion
  in
  Alcotest.check Shot.bits "the same bits"
    (Shot.picture (Written.scene (forms [ far "" ])))
    (Shot.picture (Written.scene (forms [ far "(dispersion 20)" ])))

(* Under so little dispersion only the colours are left to chance. *)
let vanishing () =
  let scene dispersion =
    Written.scene
      [
        Written.size 1 1;
        "(camera (orthographic (eye 0 0 5) (look-at 0 0 0) (height 1e-6)))";
        "(background (gradient (down (rgb .1 .2 .3)) (up (rgb .9 .7 .4))))";
        "(render (spp 4096))";
        "(sphere (center .3 .5 0) (radius 1) (material (glass (index 1.5) "
        ^ dispersion ^ ")))";
      ]
  in
  Lit.check_close ~within:2e-3 "the same in the mean"
    (Shot.pixel (scene "") 0 0)
    (Shot.pixel (scene "(dispersion 1e12)") 0 0)

let calls () =
  let count text =
    List.length
      (Dispersion.calls
         (Lit.scene
            [ "(sphere (center 0 0 0) (radius 1) (material " ^ text ^ "))" ]))
  in
  Alcotest.(check int) "with" 1 (count "(glass (index 1.5) (dispersion 40))");
  Alcotest.(check int) "without" 0 (count "(glass (index 1.5))")

let suite =
  ( "dispersion",
    [
      index_law;
      Law.example "an endless Abbe number is no dispersion" plain_index;
      Law.example "all wavelengths together are white" white;
      Law.example "wavelengths have their colours" colours;
      Law.example "light is bent by the index of its wavelength" snell;
      Law.example "blue light is bent more than red" order;
      Law.example "a path keeps its wavelength" keeps_its_own;
      Law.example "glass that does not disperse asks for none" none_needed;
      Law.example "but does within glass that disperses" in_dispersive;
      Law.example "paths that meet no such glass keep their bits" unmet;
      Law.example "vanishing dispersion vanishes in the mean" vanishing;
      Law.example "an Abbe number calls for it" calls;
    ] )

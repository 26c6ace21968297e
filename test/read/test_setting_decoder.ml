open Candor_space
open Candor_colour
open Candor_read
open Candor_scene
open Text

let image = Setting_decoder.image
let render = Setting_decoder.render
let background = Setting_decoder.background

let sizes () =
  let reads = Piece.reads ( = ) image in
  reads "(image (size 640 480))" (640, 480);
  reads "(image (size 1 65536))" (1, 65536);
  Piece.refuses image "(image)" [ "1 (image ...) needs (size W H)" ];
  Piece.refuses image "(image (size 0 65537))"
    [
      "14 W of (size ...) must be from 1 to 65536, but is `0`";
      "16 H of (size ...) must be from 1 to 65536, but is `65537`";
    ];
  Piece.refuses image "(image (size 1.5 2))"
    [ "14 `1.5` is not a whole number" ]

let d = Scene.default_settings
let reads = Piece.reads Scene.equal_settings render

let settings () =
  reads "(render)" d;
  reads "(render (spp 7))" { d with spp = 7 };
  reads "(render (depth 0))" { d with depth = Some 0 };
  reads "(render (cutoff .25))" { d with cutoff = 0.25 };
  reads "(render (seed 0))" { d with seed = 0 };
  reads (Printf.sprintf "(render (seed %d))" max_int) { d with seed = max_int };
  reads "(render (filter tent))" { d with filter = Tent };
  reads "(render (filter box))" { d with filter = Box };
  reads
    "(render (filter tent) (seed 5) (cutoff 1) (depth 1073741824) (spp \
     1073741824))"
    {
      spp = 0x40000000;
      depth = Some 0x40000000;
      cutoff = 1.;
      seed = 5;
      filter = Tent;
      error = None;
      time = None;
    };
  let most = { d with spp = Scene.most_samples } in
  reads "(render (error .5))" { most with error = Some 0.5 };
  reads "(render (time 1.5m))" { most with time = Some 90. };
  reads "(render (time 3))" { most with time = Some 3. };
  reads "(render (time 20s) (spp 64) (error 1))"
    { d with spp = 64; error = Some 1.; time = Some 20. }

let no_settings () =
  let refuses = Piece.refuses render in
  refuses "(render (spp 0))"
    [ "14 (spp ...) must be from 1 to 1073741824, but is `0`" ];
  refuses "(render (depth -1))"
    [ "16 (depth ...) must be from 0 to 1073741824, but is `-1`" ];
  refuses "(render (cutoff 1.5))"
    [ "17 (cutoff ...) must be from 0 to 1, but is `1.5`" ];
  refuses "(render (seed -1))"
    [ Printf.sprintf "15 (seed ...) must be from 0 to %d, but is `-1`" max_int ];
  refuses "(render (filter tend))"
    [ "17 expected `box` or `tent`, not `tend`; did you mean `tent`?" ];
  refuses "(render (error 0) (time 0s))"
    [
      "16 (error ...) must be above 0, but is `0`";
      "25 `0s`: expected a time above 0, such as 20s or 1.5m";
    ];
  refuses "(render (error inf) (time (s 3)))"
    [ "16 `inf` is not a number"; "27 expected a time, not (s ...)" ];
  refuses "(render (spp 1) (spp 1))"
    [ "17 (spp ...) is given twice in (render ...); the first is at 1:9" ]

let backgrounds () =
  let reads = Piece.reads Scene.equal_background background in
  reads "(background .5)" (Uniform (Rgb.grey 0.5));
  reads "(background (rgb 1 2 3))" (Uniform (Rgb.v 1. 2. 3.));
  reads "(background (gradient (down 1) (up (rgb 0 0 9))))"
    (Gradient { down = Rgb.white; up = Rgb.v 0. 0. 9. });
  reads "(background (gradient (up (rgb 0 0 9)) (down 1)))"
    (Gradient { down = Rgb.white; up = Rgb.v 0. 0. 9. })

let no_backgrounds () =
  let refuses = Piece.refuses background in
  refuses "(background -1)" [ "13 a colour must not be negative, but is `-1`" ];
  refuses "(background (gradient (up 1)))"
    [ "13 (gradient ...) needs (down COLOUR)" ];
  refuses "(background (image))" [ "13 expected (image FILE), found nothing" ];
  refuses "(background (sky))"
    [ "13 unknown background `sky`; expected rgb, gradient or image" ]

let fog =
  let reads text value =
    Piece.reads
      (fun (a : _ Scene.placed) (b : _ Scene.placed) ->
        Scene.equal_fog a.value b.value)
      Setting_decoder.fog text
      { Scene.value; place = Place.unknown }
  in
  fun () ->
    reads "(fog (extinction .1) (albedo (rgb 1 0 .5)))"
      {
        extinction = Rgb.grey 0.1;
        albedo = Rgb.v 1. 0. 0.5;
        anisotropy = 0.;
        within = None;
      };
    reads
      "(fog (within (max 4 5 6) (min 1 2 3)) (anisotropy -.5) (albedo 0) \
       (extinction 7))"
      {
        extinction = Rgb.grey 7.;
        albedo = Rgb.black;
        anisotropy = -0.5;
        within = Some (Bounds.v (Point.v 1. 2. 3.) (Point.v 4. 5. 6.));
      }

let no_fog () =
  let refuses = Piece.refuses Setting_decoder.fog in
  refuses "(fog)"
    [
      "1 (fog ...) needs (albedo COLOUR)";
      "1 (fog ...) needs (extinction COLOUR)";
    ];
  refuses "(fog (extinction -1) (albedo 2) (anisotropy -1))"
    [
      "18 a colour must not be negative, but is `-1`";
      "30 a colour must be from 0 to 1, but is `2`";
      "45 (anisotropy ...) must be above -1 and below 1, but is `-1`";
    ];
  refuses "(fog (extinction 1) (albedo 1) (within (min 0 0 0) (max 1 0 1)))"
    [ "32 (within ...): min must be below max on every axis" ]

let indirect () =
  Piece.reads Place.equal Setting_decoder.indirect " (indirect-light)"
    { file = ""; line = 1; column = 2 };
  Piece.refuses Setting_decoder.indirect "(indirect-light no)"
    [ "1 expected (indirect-light), found 1 word" ]

(* Every field that is written is read, and every one that is not has its
   default. *)
let any_settings =
  let open QCheck2.Gen in
  let part write d g =
    let+ x = g and+ written = bool in
    if written then (write x, x) else ("", d)
  in
  let+ s, spp = part (Printf.sprintf "(spp %d)") d.spp (int_range 1 999)
  and+ e, depth =
    part
      (Option.fold ~none:"" ~some:(Printf.sprintf "(depth %d)"))
      d.depth
      (map Option.some (int_bound 99))
  and+ c, cutoff =
    part (Printf.sprintf "(cutoff %h)") d.cutoff (float_range 0. 1.)
  and+ n, seed = part (Printf.sprintf "(seed %d)") d.seed nat
  and+ f, filter =
    part
      (fun (f : Scene.filter) ->
        match f with Box -> "(filter box)" | Tent -> "(filter tent)")
      d.filter
      (map (fun b : Scene.filter -> if b then Box else Tent) bool)
  in
  ( Printf.sprintf "(render %s %s %s %s %s)" f c s n e,
    { d with spp; depth; cutoff; seed; filter } )

let defaults =
  law ~count:500 "what is left out of the settings has its default" ~print:fst
    any_settings (fun (text, expected) ->
      match Piece.body render text with
      | Some found, [] -> Scene.equal_settings expected found
      | (Some _ | None), _ -> false)

let suite =
  ( "setting decoder",
    [
      case "a picture has from 1 to 65536 pixels each way" sizes;
      case "each setting is read" settings;
      case "what is no setting is told" no_settings;
      defaults;
      case "fog is everywhere and scatters evenly unless told otherwise" fog;
      case "what is no fog is told" no_fog;
      case "indirect light is asked for, and no more" indirect;
      case "a background is a colour of light, or a gradient" backgrounds;
      case "what is no background is told" no_backgrounds;
    ] )

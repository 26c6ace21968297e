(* A thin beam through a prism of glass that disperses light. *)

open Candor_colour
open Candor_oracle

let apex = Float.pi *. 40. /. 180.

(* Corners of a prism with an apex of 40 degrees at (0, h) and a level base,
   from z = -9 to 9. *)
let prism dispersion =
  let h = 1. /. tan (apex /. 2.) in
  let p x y z = Printf.sprintf "(%.17g %.17g %d)" x y z in
  let polygon corners = "(polygon " ^ String.concat " " corners ^ ")" in
  let faces =
    [
      [ p (-1.) 0. 9; p 1. 0. 9; p 0. h 9 ];
      [ p (-1.) 0. (-9); p 0. h (-9); p 1. 0. (-9) ];
      [ p (-1.) 0. (-9); p 1. 0. (-9); p 1. 0. 9; p (-1.) 0. 9 ];
      [ p 1. 0. (-9); p 0. h (-9); p 0. h 9; p 1. 0. 9 ];
      [ p 0. h (-9); p (-1.) 0. (-9); p (-1.) 0. 9; p 0. h 9 ];
    ]
  in
  Printf.sprintf "(group %s (material (glass (index 1.5) (dispersion %g))))"
    (String.concat " " (List.map polygon faces))
    dispersion

(* How far a level ray to the right ends up turned down, by Snell's law twice,
   in radians. *)
let deviation index =
  let into = apex /. 2. in
  let inside = asin (sin into /. index) in
  let out = asin (index *. sin (apex -. inside)) in
  into +. out -. apex

(* Paths leave with their wavelength: the rays that reach the sky beyond. *)
let spread () =
  let scene =
    Candor_scene_made.Written.scene
      [
        Measure.look ~from:"-9 .8 0" "0 .8 0";
        Measure.settings ~spp:64 1;
        "(background 1)";
        prism 25.;
      ]
  in
  let found = ref [] in
  let watch : Candor_effect.Event.t -> unit = function
    | Enter { ray; throughput; _ } -> found := (ray, throughput) :: !found
    | _ -> ()
  in
  let tally = Candor_effect.Tally.make ~watch () in
  let pixel = Candor_trace.Pixel.compile scene in
  for sample = 0 to 63 do
    ignore
      (Candor_trace.Pixel.sample pixel tally ~x:0 ~y:0 ~sample
        : Candor_colour.Rgb.t)
  done;
  (* Those of them that are turned down by no more than what glass between 1.45
     and 1.6 does and carry most of the light have crossed both faces. *)
  let angle (ray : Candor_space.Ray.t) =
    Float.atan2 (-.ray.direction.y) ray.direction.x
  in
  let crossed =
    List.filter
      (fun ((ray : Candor_space.Ray.t), throughput) ->
        ray.origin.x > 0.
        && angle ray > deviation 1.45
        && angle ray < deviation 1.6
        && Rgb.largest throughput > 0.)
      !found
  in
  Alcotest.(check bool) "light comes through" true (List.length crossed >= 60);
  let index l = Candor_effect.Dispersion.index_at ~index:1.5 ~abbe:25. l in
  let least = deviation (index 720.) and most = deviation (index 380.) in
  List.iter
    (fun (ray, _) ->
      let a = angle ray in
      if not (least -. 1e-9 <= a && a <= most +. 1e-9) then
        Alcotest.failf "turned by %g, not from %g to %g" a least most)
    crossed;
  (* The mean colours of what is turned little and of what is turned a lot. *)
  let colour near =
    List.filter (fun (ray, _) -> near (angle ray)) crossed
    |> List.fold_left (fun sum (_, c) -> Rgb.add sum c) Rgb.black
  in
  let red = colour (fun a -> a < deviation (index 610.))
  and blue = colour (fun a -> a > deviation (index 470.)) in
  Alcotest.(check bool) "red is turned least" true (red.r > 4. *. red.b);
  Alcotest.(check bool) "blue is turned most" true (blue.b > 4. *. blue.r)

(* A white sky stays white, and so does glass that barely disperses. *)
let furnace () =
  let shown more =
    Measure.v
      ([
         Measure.look ~from:"1 2 4" ".5 .3 .8";
         Measure.settings 40;
         Measure.indirect;
         "(background 1)";
       ]
      @ more)
  in
  Measure.is "in a white sky" Rgb.white
    (shown
       [
         "(sphere (center 0 0 0) (radius 1) (material (glass (index 1.5) \
          (dispersion 20))))";
         "(sphere (center .2 0 0) (radius .5) (material (glass (index 1.8) \
          (dispersion 40))))";
       ])

let vanishing () =
  let shown dispersion =
    Measure.v
      [
        Measure.look ~from:"1 2 4" ".5 .3 .8";
        Measure.settings ~spp:32 32;
        Measure.indirect;
        "(background (gradient (down (rgb .1 .2 .3)) (up (rgb .9 .7 .4))))";
        "(sphere (center 0 0 0) (radius 1) (material (glass (index 1.5) "
        ^ dispersion ^ ")))";
      ]
  in
  Measure.agree "vanishing dispersion" (shown "(dispersion 1e12)") (shown "")

let suite =
  ( "prism",
    [
      Law.example "a prism turns each colour by Snell's law, blue most" spread;
      Law.example "glass that disperses stays white under a white sky" furnace;
      Law.example "vanishing dispersion vanishes in the mean" vanishing;
    ] )

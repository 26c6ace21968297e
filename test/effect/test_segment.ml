open Candor_oracle
open Candor_space
open Candor_colour
open Candor_effect
open Called

let ray = Lit.ray (0., 0., 5.) (0., 3., -4.)
let exact = Alcotest.(check (float 0.))

let lengths () =
  let s = Lit.scene [ "(quadric (plane (normal 0 0 1) (offset 1)))" ] in
  let hit = Lit.hit s (0., 0., 5.) (0., 3., -4.) in
  near "to a plane" 5. (Segment.length ray (Some hit));
  exact "to nothing" infinity (Segment.length ray None);
  near "to a lamp" 5.
    (Segment.distance (Point.v 0. 0. 5.) (At (Point.v 0. 3. 1.)));
  exact "to a sun" infinity
    (Segment.distance Point.origin (Along (Vec.v 0. 3. 1.)))

let half : Segment.t =
 fun _ _ path ray hit arrive ->
  Segment.weighted (Rgb.v 0.5 1. 0.) path ray hit arrive

let third : Segment.t =
 fun _ _ path ray hit arrive ->
  Segment.weighted (Rgb.grey 0.25) path ray hit arrive

let run segment = segment Lit.no_recursion (Tally.make ()) Path.start ray None

let weights () =
  let seen = ref Rgb.black in
  let found =
    run (Segment.after half third) (fun path _ _ ->
        seen := path.throughput;
        Rgb.v 4. 8. 2.)
  in
  Alcotest.check Lit.rgb "what arrives" (Rgb.v 0.5 2. 0.) found;
  Alcotest.check Lit.rgb "what the path carries" (Rgb.v 0.125 0.25 0.) !seen

let suite =
  ( "segments",
    [
      Law.example "have lengths in scene units" lengths;
      Law.example "weigh what they find, one after the other" weights;
    ] )

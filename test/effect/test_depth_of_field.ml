open Candor_oracle
open Candor_effect
open Candor_scene_made
open Called

let camera lens =
  Printf.sprintf
    "(camera (perspective (eye 0 0 5) (look-at 0 0 0) (fov-y 40) %s))" lens

let calls () =
  check "a lens" Depth_of_field
    [ ""; camera "(aperture-radius .1) (focus-distance 3)" ]
    [ ("aperture of the camera", 3) ];
  check "of one point" Depth_of_field
    [ camera "(aperture-radius 0) (focus-distance 3)" ]
    [];
  check "none" Depth_of_field [ camera "" ] []

let lens () =
  let lens form = Depth_of_field.lens (Written.scene [ camera form ]) in
  near "the camera's" 0.1
    (lens "(aperture-radius .1) (focus-distance 3)").radius;
  near "in focus" 3. (lens "(aperture-radius .1) (focus-distance 3)").focus;
  near "a point" 0. (lens "").radius

let suite =
  ( "depth of field",
    [
      Law.example "a wide lens calls" calls;
      Law.example "it is the camera's" lens;
    ] )

open Candor_oracle
open Candor_effect
open Candor_scene_made
open Called

let camera shutter =
  Printf.sprintf
    "(camera (orthographic (eye 0 0 5) (look-at 0 0 0) (height 2) %s))" shutter

let open_ = camera "(shutter 0 1)"
let moves = ball "(motion 1 0 0)"

let calls () =
  check "a moving ball" Motion_blur [ open_; moves ] [ ("motion", 3) ];
  check "the shutter shut" Motion_blur [ camera ""; moves ] [];
  check "a moment later" Motion_blur
    [ camera "(shutter 1 1)"; moves ]
    [ ("motion", 3) ];
  check "all still" Motion_blur [ open_; ball "" ] [];
  check "a motion of 0" Motion_blur [ open_; ball "(motion 0 0 0)" ] [];
  check "in a group" Motion_blur
    [ open_; "(group"; moves; ")" ]
    [ ("motion", 4) ];
  check "a group" Motion_blur
    [ open_; "(group (motion 0 1 0)"; ball ""; ")" ]
    [ ("motion", 3) ];
  check "a definition in use" Motion_blur
    [ open_; "(define it " ^ moves ^ ")"; "(use it)"; "(use it)" ]
    [ ("motion", 3) ];
  check "a definition that is not" Motion_blur
    [ open_; "(define it " ^ moves ^ ")" ]
    []

let time () =
  let time shutter u = Motion_blur.time (Written.scene [ camera shutter ]) u in
  near "opens" (-2.) (time "(shutter -2 4)" 0.);
  near "halfway" 1. (time "(shutter -2 4)" 0.5);
  near "at once" 3. (time "(shutter 3 3)" 0.7);
  near "none" 0. (time "" 0.7)

let suite =
  ( "motion blur",
    [
      Law.example "what moves calls" calls;
      Law.example "times are those of the shutter" time;
    ] )

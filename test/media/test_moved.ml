(* Pictures of what moves. *)

open Candor_oracle
open Candor_effect
open Candor_scene_made

let shutter t0 t1 =
  Printf.sprintf
    "(camera (orthographic (eye 0 0 5) (look-at 0 0 0) (height 3) (shutter %g \
     %g)))"
    t0 t1

let camera_at ?(x = 0.) ?(y = 0.) (t0, t1) =
  Printf.sprintf
    "(camera (orthographic (eye %g %g 5) (look-at %g %g 0) (height 1e-6) \
     (shutter %g %g)))"
    x y x y t0 t1

let sun = "(light (directional (direction -1 -2 -3) (irradiance 3)))"
let lamp = "(light (point (at 2 2 3) (intensity 9)))"

let floor =
  "(box (min -9 -9 -2) (max 9 9 -1) (material (matte (color (checker .3 .8)))))"

let motion = function None -> "" | Some v -> Printf.sprintf "(motion %s)" v

let ball ?moves center =
  Printf.sprintf
    "(sphere (center %s) (radius .5) %s (material (matte (color (noise .1 .9 \
     (scale .25))))))"
    center (motion moves)

let prism ?moves () =
  Printf.sprintf
    "(group (transform (rotate (axis 1 2 3) (degrees 20))) %s (material \
     (mirror)) (box (min -.25 .5 0) (max .25 1 .5)))"
    (motion moves)

let view ?(spp = 4) camera surfaces =
  Written.scene
    ([ Written.size 16 16; Printf.sprintf "(render (spp %d))" spp; camera ]
    @ [ sun; lamp; floor ] @ surfaces)

let still () =
  Measured.same "a motion of 0"
    (view (shutter 0. 0.) [ ball "0 0 0"; prism () ])
    (view (shutter 0. 1.)
       [ ball ~moves:"0 0 0" "0 0 0"; prism ~moves:"0 0 0" () ]);
  Measured.same "a shutter at time 0"
    (view (shutter 0. 0.) [ ball "0 0 0"; prism () ])
    (view (shutter 0. 0.)
       [ ball ~moves:"1 2 0" "0 0 0"; prism ~moves:"1 0 0" () ])

let forced () =
  let s = view (shutter 0. 0.) [ ball "0 0 0"; prism () ] in
  Alcotest.check Shot.bits "all effects" (Shot.picture s)
    (Shot.picture ~plan:(Plan.all s) s)

(* At one time, where all that moves has the same motion, the picture is that of
   the same things further on; the patterns of surfaces go with them. *)
let at_once () =
  let s =
    view (shutter 1. 1.)
      [ ball ~moves:"1 .5 0" "-1 0 0"; prism ~moves:".5 0 0" () ]
  and moved =
    view (shutter 0. 0.)
      [
        "(group (transform (translate 1 .5 0)) " ^ ball "-1 0 0" ^ ")";
        "(group (transform (translate .5 0 0)) " ^ prism () ^ ")";
      ]
  in
  Measured.not_black "the scene" s;
  Measured.alike "further on" s moved

let scaled () =
  let s =
    view (shutter (-0.5) 1.)
      [ ball ~moves:"1 .5 0" "-1 0 0"; prism ~moves:".5 0 0" () ]
  in
  Measured.same "another scale" s (Scaled.by 0x1p20 s)

(* {1 In the mean} *)

let open_ = (0., 1.)

(* A shining ball of radius ½ crosses 4 units. *)
let coverage () =
  let runner =
    "(sphere (center -2 0 0) (radius .5) (motion 4 0 0) (material (emitter \
     (radiance 1))))"
  in
  let at y expected =
    let m =
      Measured.v (Measured.scene ~spp:64 [ camera_at ~y open_; runner ])
    in
    Measured.sharp "the runner" m;
    Measured.are "the runner" m expected expected expected
  in
  at 0. 0.25;
  at 0.3 0.2

(* A spherical lamp of radius r that moves from −a to a at height h above a floor:
   the mean of π(r/d)² cos is π r²/(h √(h² + a²)). *)
let moving_light ~indirect () =
  let s =
    Measured.scene ~spp:256
      ([
         camera_at open_;
         "(quadric (plane (normal 0 0 1) (offset 0)) (material (matte (color \
          1))))";
         "(sphere (center -2 0 1) (radius .25) (motion 4 0 0) (material \
          (emitter (radiance 1))))";
       ]
      @ if indirect then [ "(indirect-light)" ] else [])
  in
  (* The camera sees the lamp itself for a part of the time. *)
  let s =
    { s with camera = { s.camera with eye = Candor_space.Point.v 0. 0. 0.5 } }
  in
  let expected = 0.0625 /. sqrt 5. in
  let m = Measured.v s in
  Measured.sharp "under a moving lamp" m;
  Measured.are "under a moving lamp" m expected expected expected

(* The way through a slab is the same wherever that is. *)
let moving_glass () =
  let s =
    Measured.scene ~spp:8 ~pixels:8
      [
        camera_at open_;
        "(background 1)";
        "(box (min -9 -9 -2) (max 9 9 -1) (motion 1 1 3) (material (glass \
         (index 1) (absorption (rgb .5 1 2)))))";
      ]
  in
  Measured.are "a moving slab" (Measured.v s) (exp (-0.5)) (exp (-1.))
    (exp (-2.))

let inside_all_the_time () =
  let s =
    Measured.scene ~spp:64
      [
        "(camera (perspective (eye 0 0 0) (look-at 0 0 -1) (fov-y 1e-6) \
         (shutter 0 1)))";
        "(background 1)";
        "(sphere (center 0 0 0) (radius 2) (motion 0 0 1) (material (glass \
         (index 1) (absorption (rgb .5 1 2)))))";
      ]
  in
  (* From the origin to z = t − 2. *)
  let expected rate = (exp (-.rate) -. exp (-2. *. rate)) /. rate in
  let m = Measured.v s in
  Measured.sharp "a ball around" m;
  Measured.are "a ball around" m (expected 0.5) (expected 1.) (expected 2.)

(* A ball of glass passes over the camera, which is inside for half of the time
   and then sees through what is ahead. *)
let passing_camera () =
  let s =
    Measured.scene ~spp:64
      [
        "(camera (perspective (eye 0 0 0) (look-at 0 0 -1) (fov-y 1e-6) \
         (shutter 0 1)))";
        "(background 1)";
        "(sphere (center -2 0 0) (radius 1) (motion 4 0 0) (material (glass \
         (index 1) (absorption (rgb .5 1 2)))))";
      ]
  in
  let expected rate =
    Measured.integral
      (fun t ->
        let x = (4. *. t) -. 2. in
        let way = if Float.abs x < 1. then sqrt (1. -. (x *. x)) else 0. in
        exp (-.rate *. way))
      0. 1.
  in
  let m = Measured.v s in
  Measured.sharp "a passing ball" m;
  Measured.are "a passing ball" m (expected 0.5) (expected 1.) (expected 2.)

let suite =
  ( "moved",
    [
      Law.example "a motion of 0 leaves the bits" still;
      Law.example "what stands still is the same with all effects" forced;
      Law.example "at one time it is still, but elsewhere" at_once;
      Law.example "a power of two leaves the bits" scaled;
      Law.example "a ball that crosses covers a pixel for its time" coverage;
      Law.example "a moving lamp lights a floor" (moving_light ~indirect:false);
      Law.example "and with indirect light" (moving_light ~indirect:true);
      Law.example "a moving slab of glass absorbs" moving_glass;
      Law.example "a body that moves around the camera" inside_all_the_time;
      Law.example "a body that passes the camera" passing_camera;
    ] )

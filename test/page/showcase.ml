(* A small scene and its price list, made once. *)

let text =
  {|(scene (image (size 24 16))
  (camera (perspective (eye 0 1.2 5) (look-at 0 .8 0) (fov-y 40)))
  (background (rgb .2 .3 .5)) (indirect-light)
  (quadric (plane (normal 0 1 0) (offset 0)))
  (sphere (center 0 2.6 0) (radius .5) (material (emitter (radiance 6))))
  (sphere (center -.8 .7 0) (radius .7) (material (glass (index 1.5))))
  (sphere (center .9 .7 0) (radius .7)
    (material (metal (reflectance (rgb .9 .6 .4)) (roughness .2)))))|}

let price =
  lazy
    (match Candor_read.Scene_file.of_string ~name:"showcase.scene" text with
    | Error _ -> Alcotest.fail "the showcase is no scene"
    | Ok scene -> Made.price ~rungs:[ 1; 2; 4; 8; 16 ] ~finest:64 scene)

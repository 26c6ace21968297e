open Candor_oracle
open Candor_scene
open Candor_effect
open Candor_scene_made

let sphere ?(material = "") center radius =
  Printf.sprintf "(sphere (center %s) (radius %g) %s)" center radius material

let glass = Printf.sprintf "(material (glass (index %g)))"

let indices forms origin direction =
  let s = Written.scene (Called.camera :: forms) in
  Immersion.v (Lit.tracer s) Path.start (Lit.ray origin direction)
  |> List.map (fun (m : Material.t) ->
      match m.kind with
      | Glass { index; _ } | Translucent { index; _ } -> index
      | Matte _ | Phong _ | Mirror _ | Glazed _ | Metal _ | Plastic _ | Emitter
        ->
          0.)

let ways = [ (0., 0., -1.); (1., 0., 0.); (1., 2., -3.); (-0.3, 0.1, 0.2) ]

let check name expected forms origin =
  List.iter
    (fun way ->
      Alcotest.(check (list (float 0.)))
        name expected (indices forms origin way))
    ways

let inner = sphere ~material:(glass 1.3) "0 0 0" 1.
let outer = sphere ~material:(glass 1.7) "0 0 0" 2.
let beside = sphere ~material:(glass 1.9) "5 0 0" 2.
let chalk = sphere "0 0 0" 4.

let bodies () =
  check "in none" [] [ inner; outer; beside ] (0., 0., 9.);
  check "in the outer" [ 1.7 ] [ inner; outer; beside ] (0., 0., 1.5);
  check "in both" [ 1.3; 1.7 ] [ inner; outer; beside ] (0., 0.2, 0.);
  check "within what is no glass" [ 1.3 ] [ inner; chalk ] (0., 0., 0.5);
  check "of one material" [ 1.3; 1.3 ]
    [ inner; sphere ~material:(glass 1.3) "0 0 0" 2. ]
    (0., 0., 0.5)

let suite =
  ( "immersion",
    [ Law.example "the bodies around a place, whichever way it looks" bodies ]
  )

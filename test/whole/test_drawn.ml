open Candor_oracle
open Candor_scene
open Candor_effect
open Candor_scene_made
open QCheck2

let small (s : Scene.t) =
  { s with width = 8; height = 8; settings = { s.settings with spp = 1 } }

let finite s =
  let { Shot.tally; _ } = Shot.v (small s) in
  let n = Tally.get tally Non_finite in
  n = 0 || Law.fail "%d samples are not finite" n

(* Every surface, the camera and every light at a size of its own; what cannot
   be so large or small stays. *)
let extreme : Scene.t Gen.t =
  let open Gen in
  let* s = Drawn.scene Round and* seed = int in
  let rand = Random.State.make [| seed |] in
  let some x f =
    let k = Float.ldexp 1. (Random.State.int rand 401 - 200) in
    match f k x with changed -> changed | exception Invalid_argument _ -> x
  in
  let all surfaces = List.map (fun x -> some x Scaled.surface) surfaces in
  let define (d : _ Scene.named) = { d with value = all d.value } in
  return
    {
      s with
      camera = some s.camera Scaled.camera;
      lights =
        List.map
          (fun (l : Light.t) -> { l with kind = some l.kind Scaled.kind })
          s.lights;
      definitions = List.map define s.definitions;
      surfaces = all s.surfaces;
    }

let law ~count name scenes =
  Law.law ~count ~print:Drawn.show name (Gen.no_shrink scenes) finite

let suite =
  ( "scenes drawn",
    [
      law ~count:10_000 "10,000 valid scenes have no sample that is not finite"
        (Drawn.scene Round);
      law ~count:2_000
        "2,000 scenes of sizes from 2^-200 to 2^200 side by side have none"
        extreme;
    ] )

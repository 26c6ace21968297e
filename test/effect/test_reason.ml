open Candor_scene
open Candor_effect
open Candor_oracle

let written rs =
  List.map (fun (r : Reason.t) -> r.what ^ " " ^ Place.to_string r.place) rs

let materials () =
  let s =
    Lit.scene
      [
        "(sphere (center 0 0 0) (radius 1))";
        "(sphere (center 0 0 0) (radius 1) (material gold))";
        "(sphere (center 0 0 0) (radius 1) (material (mirror)))";
        "(sphere (center 0 0 0) (radius 1) (material (glazed (color .5) \
         (mirror .1))))";
        "(sphere (center 0 0 0) (radius 1) (material (phong (color .5) \
         (specular 1) (shininess 3))))";
        "(material gold (mirror (color (rgb 1 .8 .2))))";
        "(material unused (mirror))";
      ]
  in
  Alcotest.(check (list string))
    "all in use, named ones where they are named"
    [
      "matte surface made.scene:3:1";
      "material gold made.scene:8:1";
      "mirror surface made.scene:5:1";
      "glazed surface made.scene:6:1";
      "phong surface made.scene:7:1";
    ]
    (written (Reason.materials (fun _ -> true) s));
  Alcotest.(check (list string))
    "only those wanted"
    [ "glazed surface made.scene:6:1" ]
    (written
       (Reason.materials
          (fun m ->
            match m.Material.kind with
            | Glazed _ -> true
            | Matte _ | Phong _ | Mirror _ | Glass _ | Metal _ | Plastic _
            | Translucent _ | Emitter ->
                false)
          s))

let suite =
  ( "reasons",
    [ Law.example "materials give reasons with their places" materials ] )

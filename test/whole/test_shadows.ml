open Candor_oracle
open Candor_scene_made
open Expected
open Rooms

(* {1 Acne: a convex body takes no light from itself} *)

let suns = [ sun "-1 -2 -3"; sun "-3 -1 1"; sun ".001 -1 -.5" ]

let acne (name, body) =
  Law.example
    (Printf.sprintf "G24: %s alone never shadows itself, at any size" name)
    (everywhere ~standings:(Far :: Standing.all) ~lit:100
       ([
          size;
          Written.plain;
          perspective "1.5 2 3" "0 0 0" "36";
          point_light "3 3 1";
          body;
        ]
       @ suns)
       (fun _ _ -> Lit))

let lit_inside (name, body) =
  Law.example
    (Printf.sprintf "G24: a lamp inside of %s lights all of it, at any size"
       name)
    (everywhere ~standings:(Far :: Standing.all) ~lit:576
       [
         size;
         Written.plain;
         perspective ".1 .2 .3" "-1 -1 -1" "80";
         point_light "-.2 .1 .15";
         body;
       ]
       (fun _ _ -> Lit))

(* {1 Leaks: no light comes into a closed room} *)

(* From everywhere around, and from so near that the wall is as good as
   touched. *)
let outside =
  [
    point_light "0 3 0";
    point_light "3 3 3";
    point_light "-2 1.5 .25";
    point_light "0 -1.000000001 0";
    sun "-1 -1 -1";
    sun "1e-9 -1 0";
  ]

let zooms = [ "90"; "1"; ".001"; ".000001" ]

let leak (name, room) =
  Law.example
    (Printf.sprintf "G24: %s lets no light in, seen wide and close to a corner"
       name) (fun () ->
      List.iter
        (fun zoom ->
          everywhere ~lit:0
            ([
               size;
               Written.plain;
               "(background 1)";
               perspective ".1 .2 .3" "-1 -1 -1" zoom;
               room;
             ]
            @ outside)
            (fun _ _ -> Black)
            ())
        zooms)

let suite =
  ( "acne and leaks",
    List.map acne bodies @ List.map lit_inside rooms @ List.map leak rooms )

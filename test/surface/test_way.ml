open Candor_space
open Candor_surface
open Candor_oracle

let within index around = Way.Within { index; transform = None; around }
let moved around = Way.Moved { by = Vec.v 1. 2. 3.; around }
let check = Alcotest.(check (list int))
let outermost () = check "by itself" [ 3 ] (Way.path Outermost 3)

let downwards () =
  check "from the top level down" [ 2; 0; 7 ]
    (Way.path (within 0 (within 2 Outermost)) 7)

let places_stay () =
  check "a moving surface" [ 3 ] (Way.path (moved Outermost) 3);
  check "moving within moving" [ 2; 0; 7 ]
    (Way.path (moved (within 0 (moved (moved (within 2 Outermost))))) 7)

let suite =
  ( "way",
    [
      Law.example "at the top level a place is the path" outermost;
      Law.example "a path goes through the groups around" downwards;
      Law.example "motion has no place of its own" places_stay;
    ] )

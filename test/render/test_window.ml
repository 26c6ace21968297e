open Candor_render
open Candor_oracle
open Candor_scene_made

let all () =
  let w =
    Window.full (Written.scene [ Written.size 7 4; Written.flat_camera ])
  in
  Alcotest.(check bool)
    "from the top left" true
    (w = { x0 = 0; y0 = 0; x1 = 7; y1 = 4 });
  Alcotest.(check (pair int int))
    "its size" (7, 4)
    (Window.width w, Window.height w)

let part () =
  let w = { Window.x0 = 2; y0 = 1; x1 = 3; y1 = 9 } in
  Alcotest.(check (pair int int))
    "upper bounds are exclusive" (1, 8)
    (Window.width w, Window.height w)

let joined () =
  let v = { Window.x0 = 2; y0 = 1; x1 = 3; y1 = 9 }
  and w = { Window.x0 = 0; y0 = 4; x1 = 5; y1 = 6 } in
  let both = { Window.x0 = 0; y0 = 1; x1 = 5; y1 = 9 } in
  Alcotest.(check bool)
    "either way" true
    (Window.join v w = both && Window.join w v = both && Window.join v v = v)

let suite =
  ( "windows",
    [
      Law.example "the full window is all of the picture" all;
      Law.example "a part has the pixels up to its upper bounds" part;
      Law.example "two are joined in the least that has both" joined;
    ] )

open Candor_space
open Candor_scene
open Candor_oracle
open Candor_scene_made

module Window = struct
  type t = Camera.window

  let show = Camera.show_window
  let equal = Camera.equal_window
  let compare = Camera.compare_window
end

module Frame = struct
  type t = Camera.frame

  let show = Camera.show_frame
  let equal = Camera.equal_frame
  let compare = Camera.compare_frame
end

let window = { Camera.left = -1.; right = 1.; bottom = -2.; top = 2. }

let windows () =
  Derived.notices
    (module Window)
    window
    [
      ("left", { window with left = -3. });
      ("right", { window with right = 3. });
      ("bottom", { window with bottom = -3. });
      ("top", { window with top = 3. });
    ]

let wider = { window with right = 9. }

let frames () =
  Derived.notices
    (module Frame)
    (Perspective_angle { fov_y = 40. })
    [
      ("fov-y", Perspective_angle { fov_y = 50. });
      ("window", Perspective_window { window; distance = 2. });
      ("another window", Perspective_window { window = wider; distance = 2. });
      ("distance", Perspective_window { window; distance = 3. });
      ("orthographic", Orthographic_height { height = 40. });
      ("height", Orthographic_height { height = 50. });
      ("orthographic window", Orthographic_window { window });
      ("panorama", Panorama);
      ("its window", Orthographic_window { window = wider });
    ]

let cameras () =
  let camera =
    {
      Camera.eye = Point.v 0. 1. 5.;
      look_at = Point.v 0. 1. 0.;
      up = Vec.v 0. 1. 0.;
      frame = Perspective_angle { fov_y = 40. };
      near = Some 1.;
      lens = Some { radius = 1.; focus = 2. };
      shutter = { opens = 0.; closes = 1. };
      place = { file = "a.scene"; line = 3; column = 5 };
    }
  in
  Derived.notices
    (module Camera)
    camera
    [
      ("eye", { camera with eye = Point.v 0. 1. 6. });
      ("look-at", { camera with look_at = Point.v 1. 1. 0. });
      ("up", { camera with up = Vec.v 0. 2. 0. });
      ("frame", { camera with frame = Orthographic_height { height = 40. } });
      ("near", { camera with near = Some 2. });
      ("no near", { camera with near = None });
      ("lens", { camera with lens = Some { radius = 2.; focus = 2. } });
      ("focus", { camera with lens = Some { radius = 1.; focus = 3. } });
      ("no lens", { camera with lens = None });
      ("opens", { camera with shutter = { opens = -1.; closes = 1. } });
      ("closes", { camera with shutter = { opens = 0.; closes = 2. } });
      ("place", { camera with place = Place.unknown });
    ]

let suite =
  ( "cameras",
    Derived.laws (module Camera) "cameras" (Derived.often (Drawn.camera Round))
    @ Derived.laws (module Window) "windows" (Derived.often Drawn.window)
    @ [
        Law.example "each side of a window counts" windows;
        Law.example "each way to frame a picture is another" frames;
        Law.example "each field of a camera counts" cameras;
      ] )

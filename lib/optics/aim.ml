open Candor_number
open Candor_space
open Candor_scene

type basis = { right : Vec.t; above : Vec.t; forward : Vec.t }

let basis (c : Camera.t) =
  let unit default v = (Dir.of_vec_or default v :> Vec.t) in
  let forward = unit (Dir.neg Dir.z) (Point.sub c.look_at c.eye) in
  let right = unit Dir.x (Vec.cross forward (unit Dir.y c.up)) in
  let above = unit Dir.y (Vec.cross right forward) in
  { right; above; forward }

(* The window of a picture of this aspect that is [half] high either way. *)
let symmetric ~width ~height half : Camera.window =
  let across = half *. (float_of_int width /. float_of_int height) in
  { left = -.across; right = across; bottom = -.half; top = half }

let compile (c : Camera.t) ~width ~height =
  let { right; above; forward } = basis c in
  let w = float_of_int width and h = float_of_int height in
  let across (win : Camera.window) x =
    win.left +. ((win.right -. win.left) *. x /. w)
  and up (win : Camera.window) y =
    win.top -. ((win.top -. win.bottom) *. y /. h)
  in
  let beside u v = Vec.add (Vec.scale u right) (Vec.scale v above) in
  let start p d =
    match c.near with None -> p | Some near -> Point.along p d near
  in
  let perspective win distance x y =
    let aside = beside (across win x /. distance) (up win y /. distance) in
    let d = Vec.add aside forward in
    Ray.v (start c.eye d) d
  in
  let orthographic win x y =
    let p = Point.add c.eye (beside (across win x) (up win y)) in
    Ray.v (start p forward) forward
  in
  match c.frame with
  | Perspective_angle { fov_y } ->
      perspective (symmetric ~width ~height (Angle.tan (fov_y /. 2.))) 1.
  | Perspective_window { window; distance } -> perspective window distance
  | Orthographic_height { height = full } ->
      orthographic (symmetric ~width ~height (full /. 2.))
  | Orthographic_window { window } -> orthographic window

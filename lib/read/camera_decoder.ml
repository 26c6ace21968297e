open Candor_space
open Candor_scene
open Decode
open Fields
open Geometry_decoder

(* [up] has no part across the view. A power of two brings each near 1, so that
   products neither overflow nor vanish. *)
let is_along up view =
  let near_one (v : Vec.t) =
    let _, e = Float.frexp (Vec.largest v) in
    let scale x = Float.ldexp x (-e) in
    Vec.v (scale v.x) (scale v.y) (scale v.z)
  in
  Vec.equal (Vec.cross (near_one up) (near_one view)) Vec.zero

let shutter =
  let in_order (t : float array) =
    if t.(0) <= t.(1) then Ok { Camera.opens = t.(0); closes = t.(1) }
    else Error "T0 must not be above T1"
  in
  Quantity.numbers "T0 T1" Rule.length |> check in_order

(* What differs between cameras: the frame, and what may go with it. *)
type optics = {
  frame : (Camera.frame, string) result;
  near : float option;
  lens : (Camera.lens option, string) result;
}

let camera optics =
  let camera =
    let+ eye = field "eye" point
    and+ look_at = field "look-at" point
    and+ up = default "up" direction (Vec.v 0. 1. 0.)
    and+ shutter = default "shutter" shutter Camera.instant
    and+ { frame; near; lens } = optics in
    if Point.equal eye look_at then Error "eye and look-at are the same point"
    else if is_along up (Point.sub look_at eye) then
      Error "up points along the view"
    else
      let ( let* ) = Result.bind in
      let* frame = frame in
      let* lens = lens in
      Ok
        (fun place ->
          { Camera.eye; look_at; up; frame; near; lens; shutter; place })
  in
  fields camera |> check Fun.id

let near = optional "near" (Quantity.scalar "D" Rule.distance)

let window =
  let is_empty (w : Camera.window) =
    if w.left < w.right && w.bottom < w.top then Ok w
    else Error "it is empty: L must be below R, and B below T"
  in
  Quantity.numbers "L R B T" Rule.length
  |> map (fun w ->
      { Camera.left = w.(0); right = w.(1); bottom = w.(2); top = w.(3) })
  |> check is_empty

let angle_or_window =
  let+ fov_y = optional "fov-y" (Quantity.scalar "DEG" (Rule.between 0. 180.))
  and+ window = optional "window" window
  and+ distance = optional "distance" (size "D") in
  match (fov_y, window, distance) with
  | Some fov_y, None, None -> Ok (Camera.Perspective_angle { fov_y })
  | None, Some window, Some distance ->
      Ok (Camera.Perspective_window { window; distance })
  | None, None, None ->
      Error "give (fov-y DEG), or (window L R B T) with (distance D)"
  | Some _, Some _, _ -> Error "give fov-y or window, not both"
  | None, Some _, None -> Error "give (distance D) with window"
  | _, None, Some _ -> Error "give (window L R B T) with distance"

let lens =
  let+ radius = optional "aperture-radius" (Quantity.scalar "R" Rule.distance)
  and+ focus = optional "focus-distance" (size "D") in
  match (radius, focus) with
  | None, None -> Ok None
  | Some radius, Some focus -> Ok (Some { Camera.radius; focus })
  | Some _, None -> Error "give (focus-distance D) with aperture-radius"
  | None, Some _ -> Error "give (aperture-radius R) with focus-distance"

let perspective =
  let+ frame = angle_or_window and+ near = near and+ lens = lens in
  { frame; near; lens }

let height_or_window =
  let+ height = optional "height" (size "H")
  and+ window = optional "window" window in
  match (height, window) with
  | Some height, None -> Ok (Camera.Orthographic_height { height })
  | None, Some window -> Ok (Camera.Orthographic_window { window })
  | None, None -> Error "give (height H) or (window L R B T)"
  | Some _, Some _ -> Error "give height or window, not both"

let orthographic =
  let+ frame = height_or_window and+ near = near in
  { frame; near; lens = Ok None }

let panorama =
  let+ () = nothing in
  { frame = Ok Camera.Panorama; near = None; lens = Ok None }

let camera =
  choice "camera"
    [
      ("perspective", camera perspective);
      ("orthographic", camera orthographic);
      ("panorama", camera panorama);
    ]
  |> one "CAMERA" |> placed

open Candor_number
open Candor_space
open Candor_scene
open Candor_sample

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

(* The rays of a camera before a lens bends them. *)
type rays =
  | From_eye of (float -> float -> Vec.t) (* directions *)
  | Elsewhere of (float -> float -> Ray.t)

let start (c : Camera.t) p d =
  match c.near with None -> p | Some near -> Point.along p d near

let across ~width (win : Camera.window) x =
  win.left +. ((win.right -. win.left) *. x /. float_of_int width)

let up ~height (win : Camera.window) y =
  win.top -. ((win.top -. win.bottom) *. y /. float_of_int height)

let beside basis u v =
  Vec.add (Vec.scale u basis.right) (Vec.scale v basis.above)

let perspective basis ~width ~height win distance x y =
  let u = across ~width win x /. distance
  and v = up ~height win y /. distance in
  Vec.add (beside basis u v) basis.forward

let orthographic (c : Camera.t) basis ~width ~height win x y =
  let p =
    Point.add c.eye (beside basis (across ~width win x) (up ~height win y))
  in
  Ray.v (start c p basis.forward) basis.forward

(* Longitude across, latitude down. *)
let panorama basis ~width ~height x y =
  let turn = 360. *. ((x /. float_of_int width) -. 0.5)
  and rise = 180. *. (0.5 -. (y /. float_of_int height)) in
  let level = Angle.cos rise in
  let ahead = Vec.scale (level *. Angle.cos turn) basis.forward in
  Vec.add ahead (beside basis (level *. Angle.sin turn) (Angle.sin rise))

let rays (c : Camera.t) basis ~width ~height =
  let perspective = perspective basis ~width ~height
  and orthographic = orthographic c basis ~width ~height
  and symmetric = symmetric ~width ~height in
  match c.frame with
  | Perspective_angle { fov_y } ->
      From_eye (perspective (symmetric (Angle.tan (fov_y /. 2.))) 1.)
  | Perspective_window { window; distance } ->
      From_eye (perspective window distance)
  | Orthographic_height { height = full } ->
      Elsewhere (orthographic (symmetric (full /. 2.)))
  | Orthographic_window { window } -> Elsewhere (orthographic window)
  | Panorama ->
      let direction = panorama basis ~width ~height in
      Elsewhere (fun x y -> Ray.v c.eye (direction x y))

let compile (c : Camera.t) ~width ~height =
  match rays c (basis c) ~width ~height with
  | Elsewhere ray -> ray
  | From_eye direction ->
      fun x y ->
        let d = direction x y in
        Ray.v (start c c.eye d) d

let compile_lens (c : Camera.t) (lens : Camera.lens) ~width ~height =
  let basis = basis c in
  match rays c basis ~width ~height with
  | Elsewhere ray -> fun x y _ -> ray x y
  | From_eye direction ->
      fun x y p ->
        let { Vec.x = u; y = v; _ } = Warp.disk p in
        let aside = beside basis (lens.radius *. u) (lens.radius *. v) in
        let d = Vec.sub (direction x y) (Vec.scale (1. /. lens.focus) aside) in
        Ray.v (start c (Point.add c.eye aside) d) d

(* {1 Where things are seen} *)

type view = { left : float; right : float; top : float; bottom : float }

let corners (b : Bounds.t) =
  let along f = List.concat_map f in
  [ b.x0; b.x1 ]
  |> along (fun x -> [ (x, b.y0); (x, b.y1) ])
  |> along (fun (x, y) -> [ Point.v x y b.z0; Point.v x y b.z1 ])

let around places =
  let least f = List.fold_left (fun m p -> Float.min m (f p)) infinity places
  and most f =
    List.fold_left (fun m p -> Float.max m (f p)) neg_infinity places
  in
  { left = least fst; right = most fst; top = least snd; bottom = most snd }

let sight (c : Camera.t) ~width ~height b =
  let basis = basis c in
  let w = float_of_int width and h = float_of_int height in
  let place (win : Camera.window) u v =
    ( w *. (u -. win.left) /. (win.right -. win.left),
      h *. (win.top -. v) /. (win.top -. win.bottom) )
  in
  let seen p =
    let v = Point.sub p c.eye in
    (Vec.dot v basis.right, Vec.dot v basis.above, Vec.dot v basis.forward)
  in
  let near_ahead =
    let size = Vec.norm (Point.sub (Bounds.high b) (Bounds.low b)) in
    fun (_, _, ahead) -> ahead > 0x1p-20 *. size
  in
  let perspective win distance =
    let seen = List.map seen (corners b) in
    if List.for_all near_ahead seen then
      let place (u, v, ahead) =
        place win (u /. ahead *. distance) (v /. ahead *. distance)
      in
      Some (around (List.map place seen))
    else None
  and orthographic win =
    let place p =
      let u, v, _ = seen p in
      place win u v
    in
    Some (around (List.map place (corners b)))
  in
  if not (Bounds.is_finite b && Option.is_none c.lens) then None
  else
    match c.frame with
    | Perspective_angle { fov_y } ->
        perspective (symmetric ~width ~height (Angle.tan (fov_y /. 2.))) 1.
    | Perspective_window { window; distance } -> perspective window distance
    | Orthographic_height { height = full } ->
        orthographic (symmetric ~width ~height (full /. 2.))
    | Orthographic_window { window } -> orthographic window
    | Panorama -> None

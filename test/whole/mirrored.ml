(** The surfaces of a scene with the sign of one coordinate turned. *)

open Candor_space
open Candor_surface
open Candor_scene
open Candor_surface_families

let shape change x ~of_shape =
  match Shapes.change change x with
  | Some changed -> of_shape changed
  | None -> invalid_arg "a shape that cannot be mirrored"

let of_shape : Shapes.t -> Scene.shape = function
  | Sphere s -> Sphere s
  | Box b -> Box b
  | Triangle s -> Triangle s
  | Quadric q -> Quadric q

let step (c : Shapes.change) : Transform.step -> Transform.step = function
  | Translate a -> Translate (c.normal a)
  | Scale _ as s -> s
  | Rotate { axis; degrees } ->
      Rotate { axis = c.normal axis; degrees = -.degrees }
  | Matrix m ->
      let row (x, y, z, t) sign =
        let { Vec.x; y; z } = c.normal (Vec.v x y z) in
        (sign *. x, sign *. y, sign *. z, sign *. t)
      in
      let { Vec.x = sx; y = sy; z = sz } = c.normal (Vec.v 1. 1. 1.) in
      let xx, xy, xz, xt = row (m.xx, m.xy, m.xz, m.xt) sx in
      let yx, yy, yz, yt = row (m.yx, m.yy, m.yz, m.yt) sy in
      let zx, zy, zz, zt = row (m.zx, m.zy, m.zz, m.zt) sz in
      Matrix { xx; xy; xz; xt; yx; yy; yz; yt; zx; zy; zz; zt }

(* One that can be mirrored in every axis. *)
let mirrorable q =
  match Quadric.shape q with
  | Hyperbolic_paraboloid { center; radii } ->
      Made.quadric (Hyperboloid_one_sheet { center; radii })
  | _ -> q

let triangles p = List.map (fun x -> Scene.plain (Triangle x) Place.unknown) p

let rec surface f g (s : Scene.surface) : Scene.surface =
  let shape : Scene.shape =
    match s.shape with
    | Sphere x -> f (Shapes.Sphere x)
    | Box x -> f (Box x)
    | Triangle x -> f (Triangle x)
    | Quadric x -> f (Quadric (mirrorable x))
    | Polygon p ->
        Group { transform = []; surfaces = all f g (triangles p.triangles) }
    | Mesh { triangles = parts; _ } ->
        let surfaces = all f g (triangles (Array.to_list parts)) in
        Group { transform = []; surfaces }
    | Group { transform; surfaces } ->
        Group { transform = List.map g transform; surfaces = all f g surfaces }
    | Use { transform; name } -> Use { transform = List.map g transform; name }
  in
  { s with shape }

and all f g surfaces = List.map (surface f g) surfaces

let scene f g (s : Scene.t) =
  let define (d : _ Scene.named) = { d with value = all f g d.value } in
  {
    s with
    definitions = List.map define s.definitions;
    surfaces = all f g s.surfaces;
  }

(** [both change s] is [s], with polygons as the triangles that they mean and
    shapes that can be mirrored, and the same mirrored. *)
let both change s =
  ( scene of_shape Fun.id s,
    scene (fun x -> shape change x ~of_shape) (step change) s )

(** Which surface of a scene a ray meets first, in exact arithmetic.

    It shares no code with the library's intersections: it takes from it only
    the scene as described, the ray's doubles, the doubles that a step of a
    transform means and those of a quadric's polynomial. *)

open Candor_space
open Candor_scene
open Candor_oracle
open Candor_scene_made

(* A step as the doubles that it means. *)
let map : Transform.step -> Affine.t = function
  | Translate t -> { Affine.identity with xt = t.x; yt = t.y; zt = t.z }
  | Scale k -> { Affine.identity with xx = k.x; yy = k.y; zz = k.z }
  | Matrix m -> m
  | Rotate _ as turn ->
      let m = Scaled.valid (Transform.of_steps [ turn ]) in
      (Transform.forward m).high

(* The last step acts last, so it is the outermost. *)
let into steps line = Exact_map.into ~blur:0. (List.rev_map map steps) line

type seen = { at : Exact_root.t; path : int list }

(* Roots of different quadratics that agree to 200 bits are the same: those of
   so few digits cannot be nearer. *)
let before (r : Exact_root.t) (s : Exact_root.t) =
  match (r, s) with
  | _, Ratio { over; under } -> Exact_root.against r over under < 0
  | Ratio { over; under }, _ -> Exact_root.against s over under > 0
  | (Lower _ | Upper _), (Lower _ | Upper _) ->
      let x = Exact_root.approximate s in
      let slack = Exact.(power (-200) * Q.abs x) in
      Exact_root.compare r (Q.sub x slack) < 0

let nearer best (c : Crossing.t) path =
  match best with
  | _ when Exact_root.sign c.at <= 0 -> best
  | Some { at; _ } when not (before c.at at) -> best
  | Some _ | None -> Some { at = c.at; path }

(** [first scene ray] is the path of the surface that [ray] meets first; where
    several are met at the same t, that of least place. *)
let first (scene : Scene.t) ray =
  let definition name =
    let named (d : _ Scene.named) = String.equal d.name name in
    (List.find named scene.definitions).value
  in
  let met path best { Crossing.crossings; _ } =
    List.fold_left (fun best c -> nearer best c path) best crossings
  in
  let rec one path line best (s : Scene.surface) =
    match s.shape with
    | Sphere x -> met path best (Exact_sphere.truth_along x line)
    | Box x -> met path best (Exact_box.truth_along x line)
    | Triangle x -> met path best (Exact_triangle.truth_along x line)
    | Quadric x ->
        met path best
          (Exact_quadric.truth_along (Exact_quadric.of_quadric x) line)
    | Polygon { triangles; _ } ->
        let part best (i, x) =
          met (i :: path) best (Exact_triangle.truth_along x line)
        in
        List.fold_left part best (List.mapi (fun i x -> (i, x)) triangles)
    | Mesh { triangles; _ } ->
        let part best (i, x) =
          met (i :: path) best (Exact_triangle.truth_along x line)
        in
        Seq.fold_left part best (Array.to_seqi triangles)
    | Group { transform; surfaces } ->
        all path (into transform line) best surfaces
    | Use { transform; name } ->
        all path (into transform line) best (definition name)
  and all path line best surfaces =
    let member best (i, s) = one (i :: path) line best s in
    List.fold_left member best (List.mapi (fun i s -> (i, s)) surfaces)
  in
  Option.map
    (fun s -> List.rev s.path)
    (all [] (Line.of_ray ray) None scene.surfaces)

open Candor_space
open Candor_surface
open Candor_colour
open Candor_scene

type light = {
  emitter : Emitters.t;
  target : Light_target.t;
  walled : (Enclosure.wall * Light_target.t option) option;
      (* what is left of the target on the side of a wall *)
  strength : float; (* from 0 to 1 for the brightest *)
  moves : bool;
}

type t = {
  lights : light array;
  tree : Light_tree.t;
  place : int array; (* of each light in the order of the tree *)
  indices : (int list, int) Hashtbl.t; (* by path; never changed *)
  flat : bool; (* whether some target is *)
}

type vantage = { from : Point.t; departure : Ray.departure; time : float }
type sample = { index : int; direction : Dir.t; density : float }

(* {1 Making} *)

(* Beyond this 1 − cos, directions to the whole sphere are as good as points of
   its cap. *)
let cap_limit = 0.25

let walled enclosure target =
  match Light_target.ball target with
  | None ->
      let hidden wall = (wall, None) in
      Option.map hidden
        (Enclosure.beyond enclosure (Light_target.corners target))
  | Some (center, radius) -> (
      match Enclosure.best enclosure ~center ~radius with
      | Some (wall, Nothing) -> Some (wall, None)
      | Some (wall, Cap { axis; one_minus_cos }) when one_minus_cos <= cap_limit
        ->
          Some (wall, Some (Light_target.cap ~axis ~one_minus_cos target))
      | Some (_, (Cap _ | Whole)) | None -> None)

let light enclosure brightest (emitter : Emitters.t) =
  let target = Light_target.of_primitive emitter in
  let moves = not (Vec.equal emitter.velocity Vec.zero) in
  {
    emitter;
    target;
    walled = (if moves then None else walled enclosure target);
    strength = Rgb.largest (Emitters.radiance emitter) /. brightest;
    moves;
  }

let in_tree (shutter : Camera.shutter) { emitter; target; strength; _ } =
  let motion =
    Motion.v ~velocity:emitter.velocity ~shutter:(shutter.opens, shutter.closes)
  in
  let bounds = Bounds.of_points (Light_target.corners target) in
  {
    Light_tree.bounds = Motion.sweep motion bounds;
    power = strength *. Light_target.area target;
  }

let make (scene : Scene.t) =
  let emitters = Emitters.of_scene scene in
  let largest e = Rgb.largest (Emitters.radiance e) in
  let brightest =
    List.fold_left (fun m e -> Float.max m (largest e)) 0. emitters
  in
  let enclosure = Enclosure.of_scene scene in
  let lights = Array.of_list (List.map (light enclosure brightest) emitters) in
  let tree =
    Light_tree.make (Array.map (in_tree scene.camera.shutter) lights)
  in
  let place = Array.make (Array.length lights) 0 in
  Array.iteri (fun at i -> place.(i) <- at) (Light_tree.order tree);
  let indices = Hashtbl.create (Array.length lights) in
  Array.iteri
    (fun i l -> Hashtbl.add indices l.emitter.Primitives.path i)
    lights;
  let flat = Array.exists (fun l -> Light_target.is_flat l.target) lights in
  { lights; tree; place; indices; flat }

let is_empty t = Array.length t.lights = 0
let emitters t = Array.to_list (Array.map (fun l -> l.emitter) t.lights)
let known t i = 0 <= i && i < Array.length t.lights

let radiance t i =
  if known t i then Emitters.radiance t.lights.(i).emitter else Rgb.black

let index t path = Hashtbl.find_opt t.indices path
let chooses t = Array.length t.lights > 1

let rec same_path (p : int list) q =
  match (p, q) with
  | [], [] -> true
  | i :: p, j :: q -> i = j && same_path p q
  | [], _ :: _ | _ :: _, [] -> false

let is_at t i path = known t i && same_path t.lights.(i).emitter.path path

(* {1 One light} *)

(* What is sampled of a light, [None] if it is known to be hidden. *)
let seen light { from; departure; _ } =
  match light.walled with
  | None -> Some light.target
  | Some (wall, left) ->
      if Enclosure.shields wall ~departure from then left else Some light.target

(* Where the point would be if the light stood still. *)
let from_still light { from; time; _ } =
  if light.moves then
    Point.add from (Vec.neg (Vec.scale time light.emitter.velocity))
  else from

let look light vantage =
  match seen light vantage with
  | None -> Light_target.nothing
  | Some target -> Light_target.look target ~from:(from_still light vantage)

let weight light looks i vantage =
  match seen light vantage with
  | None -> 0.
  | Some target ->
      let from = from_still light vantage in
      light.strength
      *.
      if i < Array.length looks then
        Light_target.solid_angle_seen looks.(i) target ~from
      else Light_target.solid_angle target ~from

let sample_light t index looks i vantage probability p =
  let light = t.lights.(index) in
  match seen light vantage with
  | None -> None
  | Some target -> (
      let from = from_still light vantage in
      match
        if i < Array.length looks then
          Light_target.sample_seen looks.(i) target ~from p
        else Light_target.sample target ~from p
      with
      | None -> None
      | Some { direction; density } ->
          let density = probability *. density in
          if density > 0. then Some { index; direction; density } else None)

let light_density t index vantage d =
  let light = t.lights.(index) in
  match seen light vantage with
  | None -> 0.
  | Some target ->
      Light_target.density target ~from:(from_still light vantage) d

(* {1 Among the lights of a leaf} *)

let at t i = (Light_tree.order t.tree).(i)

(* What is seen of each, once for its weight and for what is sampled of it. None
   where there is nothing to be kept. *)
let looks t ({ first; count; _ } : Light_tree.leaf) vantage =
  let one i = look t.lights.(at t (first + i)) vantage in
  if t.flat then Array.init count one else [||]

let weights t ({ first; count; _ } : Light_tree.leaf) looks vantage =
  let weight i = weight t.lights.(at t (first + i)) looks i vantage in
  Float.Array.init count weight

let sum = Float.Array.fold_left ( +. ) 0.

(* The member that [left], counted in weights, ends in. *)
let rec pick weights i left =
  let w = Float.Array.get weights i in
  if i + 1 < Float.Array.length weights && left >= w then
    pick weights (i + 1) (left -. w)
  else i

let sample_among t (leaf : Light_tree.leaf) vantage p =
  if leaf.count = 1 then
    sample_light t (at t leaf.first) [||] 0 vantage leaf.probability p
  else
    let looks = looks t leaf vantage in
    let weights = weights t leaf looks vantage in
    let total = sum weights in
    if not (total > 0.) then None
    else
      let i = pick weights 0 (leaf.rest *. total) in
      let part = Float.Array.get weights i /. total in
      sample_light t
        (at t (leaf.first + i))
        looks i vantage (leaf.probability *. part) p

let sample t vantage ~choice p =
  if is_empty t then None
  else
    let leaf = Light_tree.sample t.tree ~from:vantage.from choice in
    sample_among t leaf vantage p

let probability_among t (leaf : Light_tree.leaf) vantage place =
  if leaf.count = 1 then leaf.probability
  else
    let weights = weights t leaf (looks t leaf vantage) vantage in
    let part = Float.Array.get weights (place - leaf.first) /. sum weights in
    if part > 0. then leaf.probability *. part else 0.

let density t vantage ~index d =
  let density = if known t index then light_density t index vantage d else 0. in
  if density > 0. then
    let place = t.place.(index) in
    let leaf = Light_tree.find t.tree ~from:vantage.from place in
    density *. probability_among t leaf vantage place
  else 0.

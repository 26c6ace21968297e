(** The same scene at another size and place: as written, in a group whose
    transform carries the size, in one that also turns and moves it, or in one
    that moves it some 700 units, however small it is. *)

open Candor_space
open Candor_scene
open Candor_scene_made

type t = Plain | Instanced | Turned | Far

let all = [ Plain; Instanced; Turned ]

let name = function
  | Plain -> "plain"
  | Instanced -> "instanced"
  | Turned -> "turned and instanced"
  | Far -> "instanced far away"

(** [powers] are 2^-20, 2^-15 … 2^30. *)
let powers = List.init 11 (fun i -> Float.ldexp 1. ((5 * i) - 20))

(** [sizes] are the same, every other one a little larger and no power of two.
*)
let sizes = List.mapi (fun i k -> if i land 1 = 0 then k else 1.3 *. k) powers

let steps standing size : Transform.step list =
  let turn = Transform.Rotate { axis = Vec.v 1. 2. 3.; degrees = 37. } in
  match standing with
  | Plain -> []
  | Instanced -> [ Scale (Vec.v size size size) ]
  | Turned ->
      [
        Scale (Vec.v size size size);
        turn;
        Translate (Vec.scale size (Vec.v 5. (-3.) 2.));
      ]
  | Far ->
      [
        Scale (Vec.v size size size);
        turn;
        Translate (Vec.v 700.3 (-300.1) 50.7);
      ]

let camera m size (c : Camera.t) =
  let c = Scaled.camera size c in
  let turned = Affine.vector m c.up in
  {
    c with
    eye = Affine.point m c.eye;
    look_at = Affine.point m c.look_at;
    up = turned;
  }

let light m size (l : Light.t) =
  let kind : Light.kind =
    match Scaled.kind size l.kind with
    | Point p -> Point { p with at = Affine.point m p.at }
    | Spot s ->
        Spot
          { s with at = Affine.point m s.at; toward = Affine.point m s.toward }
    | Directional d ->
        Directional { d with direction = Affine.vector m d.direction }
  in
  { l with kind }

(** [v standing size s] is [s] so, [size] times as large. *)
let v standing size (s : Scene.t) =
  match standing with
  | Plain -> Scaled.by size s
  | Instanced | Turned | Far ->
      let transform = steps standing size in
      let shape = Scene.Group { transform; surfaces = s.surfaces } in
      (* The camera and lights are scaled first, then turned and moved. *)
      let m =
        match transform with
        | [] | [ _ ] -> Affine.identity
        | _ :: moves ->
            (Transform.forward (Scaled.valid (Transform.of_steps moves))).high
      in
      {
        s with
        camera = camera m size s.camera;
        lights = List.map (light m size) s.lights;
        surfaces = [ Scene.plain shape Place.unknown ];
      }

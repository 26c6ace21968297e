(** Pictures whose every pixel is known: black, or lit as if nothing cast
    shadows. *)

open Candor_colour
open Candor_scene
open Candor_image
open Candor_scene_made

let without_shadows (s : Scene.t) =
  let light (l : Light.t) = { l with shadows = false } in
  { s with lights = List.map light s.lights }

let pixels (s : Scene.t) =
  List.init (s.width * s.height) (fun i -> (i mod s.width, i / s.width))

type expected = Black | Lit  (** by all lights, as if nothing cast shadows *)

(* The picture without shadows, if every pixel is as [f x y] says. *)
let expect name (s : Scene.t) f =
  let shot = Shot.picture s and lit = Shot.picture (without_shadows s) in
  let bad (x, y) =
    let c = Picture.pixel shot x y in
    match f x y with
    | Black -> not (Rgb.is_black c)
    | Lit -> not (Rgb.equal c (Picture.pixel lit x y))
  in
  match List.filter bad (pixels s) with
  | [] -> lit
  | (x, y) :: _ as all ->
      let { Rgb.r; _ } = Picture.pixel shot x y in
      Alcotest.failf "%s: %d bad pixels, first %d %d: %h" name (List.length all)
        x y r

let bright picture (s : Scene.t) =
  let lit (x, y) = (Picture.pixel picture x y).r > 0. in
  List.length (List.filter lit (pixels s))

(** [everywhere ~lit forms f ()] fails unless each pixel (x, y) of the scene
    [forms] is as [f x y] says, in every standing and size; at least [lit] would
    be bright without shadows. *)
let everywhere ?(standings = Standing.all) ?(sizes = Standing.sizes) ~lit forms
    f () =
  let unit = Written.scene forms in
  let stand standing size =
    let scene = Standing.v standing size unit in
    let name = Printf.sprintf "%s, size %h" (Standing.name standing) size in
    let n = bright (expect name scene f) scene in
    if n < lit then Alcotest.failf "%s: only %d pixels are lit" name n
  in
  List.iter (fun s -> List.iter (stand s) sizes) standings

let size = Written.size 24 24

let perspective eye look_at fov =
  Printf.sprintf "(camera (perspective (eye %s) (look-at %s) (fov-y %s)))" eye
    look_at fov

let point_light at =
  Printf.sprintf "(light (point (at %s) (intensity 9) (falloff none)))" at

let sun direction =
  Printf.sprintf "(light (directional (direction %s) (irradiance 3)))" direction

(* One render, as rows whose samples can be counted on. *)

open Candor_scene
open Candor_render

type t = { pixel : Candor_trace.Pixel.t; rows : Row.t array }

let make (scene : Scene.t) seed =
  {
    pixel = Case.pixel scene seed;
    rows = Array.init scene.height (Row.make ~x0:0 ~x1:scene.width);
  }

(** [take s f] gives the pixel in column x and row y its first [f x y] samples.
*)
let take s f =
  Array.iteri (fun y row -> Row.take s.pixel row (fun x -> f x y)) s.rows

(** [samples s] is how many were taken. *)
let samples s = Array.fold_left (fun n row -> n + Row.total row) 0 s.rows

let results s = Array.map Row.result s.rows

(** [adaptive s target] is what it says when it is done. *)
let adaptive s target ~pass =
  let pass f =
    take s f;
    pass ();
    Some ()
  in
  let y1 = Array.length s.rows and x1 = Row.width s.rows.(0) in
  let window = { Window.x0 = 0; y0 = 0; x1; y1 } in
  Adaptive.run window s.rows target ~pass ~expect:ignore

let sampling results =
  let add sum r = Sampling.join sum (Row.sampling r) in
  Array.fold_left add Sampling.none results

(** [linear results] is red, green and blue of all pixels. *)
let linear results =
  Array.map (fun (r : Row.result) -> r.pixels) results
  |> Array.to_list |> Float.Array.concat

(** [uniform scene seed spp] is the render with [spp] samples in each pixel. *)
let uniform scene seed spp =
  let s = make scene seed in
  take s (fun _ _ -> spp);
  results s

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
  let of_row y row =
    Row.take s.pixel row (fun x -> f x y);
    Row.result row
  in
  Array.mapi of_row s.rows

let sampling results =
  let add sum (r : Row.result) = Sampling.join sum r.sampling in
  Array.fold_left add Sampling.none results

let samples results =
  let add n (r : Row.result) = n + Array.fold_left ( + ) 0 r.counts in
  Array.fold_left add 0 results

(** [linear results] is red, green and blue of all pixels. *)
let linear results =
  Array.map (fun (r : Row.result) -> r.pixels) results
  |> Array.to_list |> Float.Array.concat

(** [uniform scene seed spp] is the render with [spp] samples in each pixel. *)
let uniform scene seed spp = take (make scene seed) (fun _ _ -> spp)

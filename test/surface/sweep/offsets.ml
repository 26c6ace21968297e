(* How far a spawned ray starts from the hit, in units of 2^-53 of the
   coordinates: the sum over the axes of the greatest of the hit's and of the
   surface's own. *)

open Candor_space
open Candor_surface
open Candor_oracle

let size (box : Bounds.t) ({ Point.x; y; z } : Point.t) =
  let most lo hi x =
    let own e = if Float.is_finite e then Float.abs e else 0. in
    Float.max (Float.abs x) (Float.max (own lo) (own hi))
  in
  most box.x0 box.x1 x +. most box.y0 box.y1 y +. most box.z0 box.z1 z

let offset surface ray =
  Option.map
    (fun (h : _ Hit.t) ->
      let size = size (Surface.bounds surface) h.point in
      if h.offset = 0. then 0. else h.offset /. (0x1p-53 *. size))
    (Surface.nearest surface ray)

let heading = Printf.sprintf "%6s %6s" "off p99" "max u"

(** [judge tally surface ~within case] counts the offset in [case], if it hits,
    and is whether it stays within. *)
let judge tally surface ~within { Family.shape; ray } =
  match offset (surface shape) ray with
  | None -> true
  | Some u ->
      Score.error tally u;
      u <= within

let row (t : Score.t) =
  Printf.sprintf "%7.2f %6.2f" (Score.quantile t 0.99) t.greatest

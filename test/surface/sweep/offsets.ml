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

(** [at_apex q p] is whether [p] is as good as at the apex of the cone [q],
    where the gradient that bounds the offset vanishes. *)
let at_apex q p =
  match Quadric.shape q with
  | Cone { apex; base; _ } ->
      Vec.norm (Point.sub p apex) < 0x1p-16 *. Vec.norm (Point.sub base apex)
  | Matrix _ | Form _ | Plane _ | Ellipsoid _ | Cylinder _ | Paraboloid _
  | Hyperbolic_paraboloid _ | Hyperboloid_one_sheet _ | Hyperboloid_two_sheets _
    ->
      false

let offset ~exempt surface ray =
  Option.bind (Surface.nearest surface ray) (fun (h : _ Hit.t) ->
      if exempt h.point then None
      else
        Some
          (let size = size (Surface.bounds surface) h.point in
           if h.offset = 0. then 0. else h.offset /. (0x1p-53 *. size)))

let heading = Printf.sprintf "%6s %6s" "off p99" "max u"

(** [judge tally ~exempt surface ~within case] counts the offset in [case], if
    it hits where it is not exempt, and is whether it stays within. *)
let judge tally ~exempt surface ~within { Family.shape; ray } =
  match offset ~exempt:(exempt shape) (surface shape) ray with
  | None -> true
  | Some u ->
      Score.error tally u;
      u <= within

let row (t : Score.t) =
  Printf.sprintf "%7.2f %6.2f" (Score.quantile t 0.99) t.greatest

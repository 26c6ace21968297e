(** Surfaces that must exist, and what the library answers about them. *)

open Candor_space
open Candor_surface
open Candor_oracle

let get what = function
  | Ok x -> x
  | Error why -> invalid_arg (Printf.sprintf "%s: %s" what why)

let sphere center radius = get "sphere" (Sphere.make ~center ~radius)
let box min max = get "box" (Box.make ~min ~max)
let triangle a b c = get "triangle" (Triangle.make { a; b; c })
let quadric ?clip ?caps shape = get "quadric" (Quadric.make ?clip ?caps shape)

(** [answer surface ray] is what the public query says. *)
let answer surface ray =
  Option.map
    (fun (h : _ Hit.t) -> { Crossing.t = h.t; side = h.side; part = h.part })
    (Surface.nearest surface ray)

let p = Point.v
let v = Vec.v

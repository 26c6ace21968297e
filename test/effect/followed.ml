(** What a term makes of a hit, and the rays it follows: the recursion answers
    white, or what [answer] says. *)

open Candor_space
open Candor_colour
open Candor_effect

type ray = { kind : string; path : Path.t; ray : Ray.t }
type t = { value : Rgb.t; rays : ray list; tally : Tally.t }

(** [v term vertex] is what comes of it; [rays] are in order. *)
let v ?(answer = fun _ -> Rgb.white) (term : Term.t) vertex =
  let rays = ref [] and tally = Tally.make () in
  let radiance _ ~kind path ray =
    let followed = { kind; path; ray } in
    rays := followed :: !rays;
    answer followed
  in
  let value = term radiance tally vertex in
  { value; rays = List.rev !rays; tally }

(** [vertex ?path scene o d] is where the ray from [o] along [d] arrives. *)
let vertex ?path scene o d =
  let view = Vec.neg (Lit.ray o d).direction in
  Lit.vertex ?path (Lit.hit scene o d) view

(** [path i] is one of many paths whose random numbers differ. *)
let path ?(inside = []) i =
  let key = Candor_sample.Key.v ~seed:1 ~x:i ~y:0 ~sample:0 ~bounce:0 Path in
  Path.camera key ~sample:0 ~time:0. ~inside

(** [mean n f] is the mean of [f path] over [n] paths. *)
let mean n f =
  let sum =
    List.fold_left
      (fun sum i -> Rgb.add sum (f (path i)))
      Rgb.black (List.init n Fun.id)
  in
  Rgb.scale (1. /. float_of_int n) sum

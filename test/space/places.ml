(** Vectors and points of every size. *)

open Candor_space
open Candor_oracle
open QCheck2

(** Any finite number, the largest and the smallest too. *)
let any =
  Gen.oneof
    [
      Draw.any_coordinate;
      Draw.signed (Draw.wide (-300.) 300.);
      Draw.pick [ max_float; -.max_float; min_float; 5e-324; 0.; -0. ];
    ]

let vec = Draw.vec (Gen.oneof [ Draw.coordinate; any ])
let ordinary = Draw.vec (Draw.uniform (-10.) 10.)
let place = Draw.point (Draw.uniform (-10.) 10.)
let show = Draw.show_vec

(** [squares a] is the exact square of the length of [a]. *)
let squares a = Exact.(dot (vec a) (vec a))

let near e x y = Float.abs (x -. y) <= e

let vec_near e (a : Vec.t) (b : Vec.t) =
  near e a.x b.x && near e a.y b.y && near e a.z b.z

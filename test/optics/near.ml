(** Words to compare results with closed forms in. *)

open Candor_space
open Candor_colour

(** [close ~within a b] is [true] iff [a] and [b] are closer than [within] times
    the larger of 1 and |b|. *)
let close ?(within = 1e-14) a b =
  Float.abs (a -. b) <= within *. Float.max 1. (Float.abs b)

let float ?within name expected actual =
  if not (close ?within actual expected) then
    Alcotest.failf "%s: expected %.17g, got %.17g" name expected actual

let rgb ?within name (expected : Rgb.t) (actual : Rgb.t) =
  float ?within (name ^ ", red") expected.r actual.r;
  float ?within (name ^ ", green") expected.g actual.g;
  float ?within (name ^ ", blue") expected.b actual.b

let triple ?within name (x, y, z) (x', y', z') =
  float ?within (name ^ ", x") x x';
  float ?within (name ^ ", y") y y';
  float ?within (name ^ ", z") z z'

let point ?within name expected (p : Point.t) =
  triple ?within name expected (p.x, p.y, p.z)

let vec ?within name expected (a : Vec.t) =
  triple ?within name expected (a.x, a.y, a.z)

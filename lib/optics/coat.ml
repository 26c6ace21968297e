open Candor_space
open Candor_colour

(* [passing] is 1 - E at the nodes of the table. *)
type surface = Smooth | Rough of { alpha : float; passing : float array }

type t = {
  boundary : Refraction.boundary;
  surface : surface;
  entering : float;
  escape : float;
}

(* The table's cosines are (i/n)^2, close where reflectance is steep. *)
let intervals = 48

let[@inline] node i =
  let s = float_of_int i /. float_of_int intervals in
  s *. s

let alpha t =
  match t.surface with Smooth -> 0. | Rough { alpha; passing = _ } -> alpha

let reflectance t c = Refraction.reflectance t.boundary c

let between table c =
  let c = if c < 0. then 0. else if c > 1. then 1. else c in
  let i = int_of_float (sqrt c *. float_of_int intervals) in
  let i = if i >= intervals then intervals - 1 else i in
  let low = node i and high = node (i + 1) in
  let w = (c -. low) /. (high -. low) in
  ((1. -. w) *. table.(i)) +. (w *. table.(i + 1))

let transmittance t c =
  match t.surface with
  | Smooth -> 1. -. reflectance t c
  | Rough { passing; alpha = _ } -> between passing c

let total n f = Seq.fold_left (fun s i -> s +. f i) 0. (Seq.take n (Seq.ints 0))

(* {1 What a surface reflects in all} *)

(* The average is taken over [turns] by [rings] points and is right within
   [slack] of itself. An index below 1 breaks the curve, where all is reflected.
*)
type care = { turns : int; rings : int; slack : float }

let care index =
  if index < 1. then { turns = 48; rings = 96; slack = 0x1p-6 }
  else { turns = 12; rings = 32; slack = 0x1p-8 }

(* The mean of f on [0;1], by points that are close at 1. *)
let mean n f =
  let n' = float_of_int n in
  let term i =
    let rest = 1. -. ((float_of_int i +. 0.5) /. n') in
    2. *. rest *. f (1. -. (rest *. rest))
  in
  total n term /. n'

(* Half of the turns do, by symmetry about the plane of view and normal. Mirrors
   that the view grazes are at the end of both. *)
let rough care boundary alpha c =
  let view = Vec.v (sqrt (1. -. (c *. c))) 0. c in
  let part u v =
    let half = Microfacet.seen ~alpha view ~u:(0.5 *. u) ~v in
    let facing = Vec.dot view half in
    let c' = (2. *. facing *. half.z) -. c in
    Refraction.reflectance boundary facing *. Microfacet.seen_again ~alpha c c'
  in
  mean care.rings (fun v -> mean care.turns (fun u -> part u v))

let reflected (boundary : Refraction.boundary) alpha c =
  let care = care boundary.into in
  Float.min 1. ((1. +. care.slack) *. rough care boundary alpha c)

(* {1 The table} *)

(* How far a curve is above the chord from the node before to the one after. *)
let bulge curve i =
  if i < 1 || i >= intervals then 0.
  else
    let low = node (i - 1) and high = node (i + 1) in
    let w = (node i -. low) /. (high -. low) in
    curve.(i) -. ((1. -. w) *. curve.(i - 1)) -. (w *. curve.(i + 1))

(* Chords are above a curve that bends up. Where it bends down, even by a kink
   between two nodes, it is raised until they are: by four bulges, of which a
   kink leaves at least a quarter, but not above what is near. *)
let above curve =
  let near f i =
    let at i = f (Int.max 0 (Int.min intervals i)) in
    Float.max (at i) (Float.max (at (i - 1)) (at (i + 1)))
  in
  let raised i y =
    let bulge = Float.max 0. (near (bulge curve) i) in
    Float.min (y +. (4. *. bulge)) (near (Array.get curve) i)
  in
  Array.mapi raised curve

(* The integral of 2c times the table, whose pieces are straight. *)
let integral table =
  let piece i =
    let low = node i and high = node (i + 1) in
    (high -. low) /. 3.
    *. ((((2. *. low) +. high) *. table.(i))
       +. ((low +. (2. *. high)) *. table.(i + 1)))
  in
  total intervals piece

let rough_surface boundary alpha =
  let reflected i = reflected boundary alpha (node i) in
  let passing =
    Array.map (fun e -> 1. -. e) (above (Array.init (intervals + 1) reflected))
  in
  (Rough { alpha; passing }, integral passing)

(* From both sides of a smooth boundary enters the same of one beam's light,
   whose extent in direction the index squared multiplies. *)
let rec entering_smooth index =
  if index < 1. then index *. index *. entering_smooth (1. /. index)
  else
    let boundary = { Refraction.from = 1.; into = index } in
    let even u = 2. *. (1. -. u) in
    let enters u =
      even u *. (1. -. Refraction.reflectance boundary (1. -. u))
    in
    mean 256 enters /. mean 256 even

let make ~index ~roughness =
  let boundary = { Refraction.from = 1.; into = index } in
  let surface, entering =
    if roughness > 0. then rough_surface boundary (Float.max roughness 0x1p-32)
    else (Smooth, entering_smooth index)
  in
  let escape = Float.min 1. (entering /. (index *. index)) in
  { boundary; surface; entering; escape }

(* {1 The base} *)

(* What leaves the base has a part [escape] that gets out. *)
let[@inline] returned escape k = escape *. k /. (1. -. k +. (escape *. k))

let albedo t (color : Rgb.t) =
  if t.entering > 0. then
    Rgb.v
      (returned t.escape color.r)
      (returned t.escape color.g)
      (returned t.escape color.b)
  else Rgb.black

let base t color =
  if t.entering > 0. then
    Rgb.scale (1. /. (Float.pi *. t.entering)) (albedo t color)
  else Rgb.black

(** Random numbers, vectors and rays, the awkward ones far more often than
    chance would have them. Counterexamples shrink towards numbers of few bits.
*)

open Candor_space
open QCheck2
open Gen

(* {1 Numbers} *)

(** [significant x] is how many bits the mantissa of [x] needs. *)
let significant x =
  if x = 0. then 0
  else
    let m = Int64.of_float (Float.ldexp (fst (Float.frexp x)) 53) in
    let rec bits n m =
      if Int64.rem m 2L = 0L then bits (n - 1) (Int64.div m 2L) else n
    in
    bits 53 m

(** [rounded n x] is [x] with a mantissa of [n] bits. *)
let rounded n x =
  let m, e = Float.frexp x in
  Float.ldexp (Float.round (Float.ldexp m n)) (e - n)

let simpler x =
  if not (Float.is_finite x) then Seq.empty
  else
    List.to_seq (0. :: 1. :: List.map (fun n -> rounded n x) [ 1; 3; 8; 20; 40 ])
    |> Seq.filter (fun y ->
        significant y < significant x || (significant x = 1 && x <> 1. && y = 1.))

let number lo hi draw =
  let within x = lo <= x && x <= hi in
  make_primitive ~gen:draw ~shrink:(fun x -> Seq.filter within (simpler x))

(** [uniform lo hi] is a number between. *)
let uniform lo hi =
  number lo hi (fun s -> lo +. Random.State.float s (hi -. lo))

(** [wide lo hi] is 10^u with u uniform in lo..hi. *)
let wide lo hi =
  number (10. ** lo) (10. ** hi) (fun s ->
      10. ** (lo +. Random.State.float s (hi -. lo)))

(** [pick xs] is one of [xs]. *)
let pick xs = oneof_array (Array.of_list xs)

let sign = pick [ 1.; -1. ]

(** [signed g] is a number of [g] with either sign. *)
let signed g = map2 ( *. ) sign g

(** [power lo hi] is 2^k with k in lo..hi. *)
let power lo hi = map (Float.ldexp 1.) (int_range lo hi)

(** [small n] is a whole number in -n..n. *)
let small n = map float_of_int (int_range (-n) n)

(** [either p a b] is [a] with probability [p] percent, else [b]. *)
let either p a b =
  let* k = int_bound 99 in
  if k < p then a else b

(** [snapped g] is [g], every other time rounded to a whole number. *)
let snapped g =
  let* x = g and* snap = bool in
  return (if snap then Float.round x else x)

(** [nudged g] is [g], now and then moved by a few ulps. *)
let nudged g =
  let* x = g and* k = int_range (-12) 3 in
  return
    (if x = 0. then x
     else if k = 1 then Float.succ x
     else if k = 2 then Float.pred x
     else if k = 3 then Float.succ (Float.succ x)
     else x)

(** Numbers of every kind and size up to about 10^8. *)
let coordinate =
  oneof
    [
      small 4;
      small 4;
      uniform (-10.) 10.;
      signed (wide (-8.) 8.);
      signed (power (-30) 30);
      nudged (small 4);
      pick [ 0.; -0.; 1.; -1.; 0x1p-200; 0.5 ];
    ]

(** The same, and the smallest numbers there are. *)
let any_coordinate =
  let tiny = pick [ 5e-324; -5e-324; 0x1p-1022; -0x1p-1022; 0x1p-400 ] in
  oneof [ coordinate; coordinate; coordinate; tiny ]

(** [pool n g] is one of [n] that are drawn from [g] once, for what is costly to
    make. *)
let pool n g =
  let trees =
    lazy
      (let rand = Random.State.make [| n |] in
       Array.init n (fun _ -> generate_tree ~rand g))
  in
  let one s = (Lazy.force trees).(Random.State.int s n) in
  map Tree.root (make_primitive ~gen:one ~shrink:Tree.children)

(* {1 Vectors} *)

let map3 f a b c = map3 f a b c
let vec g = map3 Vec.v g g g
let point g = map3 Point.v g g g

(** [unit] is a direction, evenly spread. *)
let unit =
  let+ a = vec (uniform (-1.) 1.) and+ k = int_bound 9 in
  let axis =
    if k = 0 then Vec.v 1. 0. 0. else if k = 1 then Vec.v 0. (-1.) 0. else a
  in
  match Dir.of_vec axis with Some d -> (d :> Vec.t) | None -> Vec.v 0. 0. 1.

let normalised a =
  match Dir.of_vec a with Some d -> (d :> Vec.t) | None -> Vec.v 1. 0. 0.

(** [across a] is a unit vector at right angles to [a], up to rounding. *)
let across a =
  let+ b = vec (uniform (-1.) 1.) in
  normalised (Vec.cross a b)

let toward (o : Point.t) (p : Point.t) = Point.sub p o
let move p a k = Point.add p (Vec.scale k a)

(** [axial] is a direction along an axis, its zeros of either sign. *)
let axial =
  let* k = int_bound 2 and* s = sign and* z = pick [ 0.; -0. ] in
  return
    (Vec.v
       (if k = 0 then s else z)
       (if k = 1 then s else z)
       (if k = 2 then s else z))

(** [stretched d] is [d], every other time multiplied by a power of two. *)
let stretched d =
  let* k = either 50 (return 0) (int_range (-60) 60) in
  return (Vec.scale (Float.ldexp 1. k) d)

(** [ray_at p] is a ray whose line passes at or near [p]: its origin is drawn,
    and its direction is what rounding leaves of the difference. *)
let ray_at (p : Point.t) =
  let* o =
    oneof
      [
        point coordinate;
        point (small 6);
        point (uniform (-10.) 10.);
        (let+ d = unit and+ k = wide (-3.) 6. in
         move p d k);
        (let+ d = axial and+ k = small 9 in
         move p d k);
      ]
  in
  let* d = stretched (toward o p) in
  if Vec.largest d > 0. then return (Ray.v o d)
  else map (fun d -> Ray.v o d) unit

(** [ray] is a ray from anywhere to anywhere. *)
let ray =
  let* p = point coordinate in
  ray_at p

(* {1 Printing} *)

let show_point (p : Point.t) = Printf.sprintf "(%h %h %h)" p.x p.y p.z
let show_vec (a : Vec.t) = Printf.sprintf "(%h %h %h)" a.x a.y a.z

let show_ray (r : Ray.t) =
  Printf.sprintf "ray from %s along %s%s" (show_point r.origin)
    (show_vec r.direction)
    (match r.departure with
    | Nowhere -> ""
    | Surface _ -> " leaving " ^ Ray.show_departure r.departure)

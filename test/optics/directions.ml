(** Functions of directions: their integrals, and whether samples are as dense
    as they say.

    The sphere is cut into cells around a focus: rings of equal chance for the
    peak of a rough reflection of this width, and equal turns. Reflections are
    cut by the mirrors that they need, because at grazing angles the mirrors'
    peak is round, but the reflections' is not. *)

open Candor_space
open Candor_sample

type t = { frame : Frame.t; width : float; view : Dir.t option }

let rings = 24
let turns = 16

(** [around axis ~width] has its focus at [axis]. *)
let around axis ~width = { frame = Frame.of_dir axis; width; view = None }

(** [reflected ~normal ~view ~width] has its focus where a mirror reflects
    [view]. *)
let reflected ~normal ~view ~width =
  { frame = Frame.of_dir normal; width; view = Some view }

(* [x] in [0;1[ counts out from the focus, [y] around it: the tangent of half
   the angle is width x/(1 - x). *)
let tangent t x = t.width *. x /. (1. -. x)

let direction t x y =
  let tangent = tangent t x in
  let square = 1. +. (tangent *. tangent) in
  let sine = 2. *. tangent /. square and turn = 2. *. Float.pi *. y in
  Warp.to_world t.frame
    (Vec.v (sine *. cos turn) (sine *. sin turn) ((2. /. square) -. 1.))

(* Solid angle over the area in x and y. *)
let stretch t x =
  let tangent = tangent t x in
  let square = 1. +. (tangent *. tangent) in
  8. *. Float.pi *. tangent /. (square *. square) *. t.width
  /. ((1. -. x) *. (1. -. x))

(* What [f] adds at (x, y), over the area there. *)
let share t f x y =
  let d = direction t x y in
  match t.view with
  | None -> stretch t x *. f d
  | Some view ->
      let facing = Dir.dot view d in
      if facing <= 0. then 0.
      else
        let mirrored =
          Vec.sub (Vec.scale (2. *. facing) (d :> Vec.t)) (view :> Vec.t)
        in
        4. *. facing *. stretch t x *. f (Dir.of_vec_or d mirrored)

let cell t (d : Dir.t) =
  let between (view : Dir.t) =
    Dir.of_vec_or d (Vec.add (d :> Vec.t) (view :> Vec.t))
  in
  let d = Option.fold ~none:d ~some:between t.view in
  let { Vec.x; y; z } = Warp.to_local t.frame d in
  let tangent = sqrt ((x *. x) +. (y *. y)) /. (1. +. z) in
  let out = if z <= -1. then 1. else tangent /. (tangent +. t.width) in
  let around = (atan2 y x /. (2. *. Float.pi)) +. 1. in
  let ring = Int.min (rings - 1) (int_of_float (out *. float_of_int rings)) in
  (ring * turns) + (int_of_float (around *. float_of_int turns) mod turns)

let sum n f =
  let total = ref 0. in
  for i = 0 to n - 1 do
    total := !total +. f i
  done;
  !total

(** [over_cell t k f] is the integral of [f] over cell [k], by [fine]² points.
*)
let over_cell ?(fine = 24) t k f =
  let step = 1. /. float_of_int fine in
  let place whole n i =
    (float_of_int whole +. ((float_of_int i +. 0.5) *. step)) /. float_of_int n
  in
  let at i j =
    share t f (place (k / turns) rings i) (place (k mod turns) turns j)
  in
  sum fine (fun i -> sum fine (at i))
  *. step *. step
  /. float_of_int (rings * turns)

(** [integral t f] is the integral of [f] over the sphere. *)
let integral ?fine t f = sum (rings * turns) (fun k -> over_cell ?fine t k f)

(** [uniform i k] is the [k]-th random number of case [i]. *)
let uniform i k =
  let key = Key.v ~seed:7 ~x:0 ~y:0 ~sample:i ~bounce:0 Film in
  Key.float (Key.derive key k)

(* What chance leaves empty of cells that expect few is no chi-square: those
   are counted together. *)
let statistic counts expected =
  let off n e = ((float_of_int n -. e) ** 2.) /. e in
  let term (sum, freedom, rest, rest') n e =
    if e >= 8. then (sum +. off n e, freedom + 1, rest, rest')
    else (sum, freedom, rest + n, rest' +. e)
  in
  let sum, freedom, rest, rest' =
    Seq.fold_left2 term (0., -1, 0, 0.) (Array.to_seq counts)
      (Array.to_seq expected)
  in
  let rest = ((float_of_int rest -. rest') ** 2.) /. Float.max 8. rest' in
  let freedom = float_of_int (Int.max 1 freedom) in
  (sum +. rest -. freedom) /. sqrt (2. *. freedom)

(** [follows name t ~density sample] fails unless the directions [sample i] are
    as dense as [density], and as often none as that leaves; [count] of them.
    Chance fails it less than once in a million times. *)
let follows ?(count = 40_000) name t ~density sample =
  let cells = rings * turns in
  let counts = Array.make (cells + 1) 0 in
  for i = 0 to count - 1 do
    let k = Option.fold ~none:cells ~some:(cell t) (sample i) in
    counts.(k) <- counts.(k) + 1
  done;
  let chance = Array.init cells (fun k -> over_cell t k density) in
  let none = 1. -. Array.fold_left ( +. ) 0. chance in
  let expected =
    Array.map
      (fun p -> float_of_int count *. p)
      (Array.append chance [| Float.max 0. none |])
  in
  if none < -0.01 then
    Alcotest.failf "%s: density of %g in all" name (1. -. none);
  let z = statistic counts expected in
  if not (z < 6.) then
    Alcotest.failf "%s: chi-square is %.1f deviations from its mean" name z

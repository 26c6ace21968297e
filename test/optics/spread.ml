(** Whether directions are spread as their density says. *)

open Candor_space
open Candor_sample

(* The square of places in the cone around [axis] is cut into cells of equal
   solid angle, by 1 − cos and by the angle around. *)
let columns = 24
let rows = 12
let cells = rows * columns

let cell frame one_minus_cos (d : Dir.t) =
  let { Vec.x; y; z = _ } = Warp.to_local frame d in
  let apart = Vec.sub (d :> Vec.t) (frame.Frame.w :> Vec.t) in
  let rise = 0.5 *. Vec.dot apart apart /. one_minus_cos in
  let turn = 0.5 +. (Float.atan2 y x /. (2. *. Float.pi)) in
  let part n x = min (n - 1) (int_of_float (float_of_int n *. x)) in
  if rise > 1. +. 0x1p-30 then None
  else Some ((part rows rise * columns) + part columns turn)

let direction frame one_minus_cos rise turn =
  let h = rise *. one_minus_cos in
  let angle = 2. *. Float.pi *. (turn -. 0.5) in
  let k = sqrt (h *. (2. -. h)) in
  Warp.to_world frame (Vec.v (k *. cos angle) (k *. sin angle) (1. -. h))

(* The integral of the density over each cell, by the midpoints of a grid. *)
let expected frame one_minus_cos density fine =
  let middle i n k =
    (float_of_int ((i * fine) + k) +. 0.5) /. float_of_int (n * fine)
  in
  let solid_angle = 2. *. Float.pi *. one_minus_cos in
  Array.init cells (fun c ->
      let sum = ref 0. in
      for k = 0 to fine - 1 do
        for l = 0 to fine - 1 do
          let rise = middle (c / columns) rows k
          and turn = middle (c mod columns) columns l in
          sum := !sum +. density (direction frame one_minus_cos rise turn)
        done
      done;
      !sum *. solid_angle /. float_of_int (cells * fine * fine))

(** [check name ~axis ~one_minus_cos ~sample ~density] fails unless [density]
    integrates to [all] (default 1) over the cone around [axis], and the
    directions of [sample], which must all lie in it, are spread by it: by
    chi-square over 288 cells, which chance fails less than once in a million
    times. *)
let check ?(count = 40000) ?(fine = 16) ?(all = 1.) name ~axis ~one_minus_cos
    ~sample ~density =
  let frame = Frame.of_dir axis in
  let expected = expected frame one_minus_cos density fine in
  let total = Array.fold_left ( +. ) 0. expected in
  if Float.abs (total -. all) > 0.01 then
    Alcotest.failf "%s: the density integrates to %g, not %g" name total all;
  let counts = Array.make cells 0 in
  let rand = Random.State.make [| Hashtbl.hash name |] in
  let uniform () = Random.State.float rand 1. in
  for _ = 1 to count do
    let u = uniform () in
    let v = uniform () in
    match sample { Pattern.u; v } with
    | None -> ()
    | Some d -> (
        match cell frame one_minus_cos d with
        | Some c -> counts.(c) <- counts.(c) + 1
        | None -> Alcotest.failf "%s: a direction out of the cone" name)
  done;
  let chi = ref 0. and bins = ref 0 and rest = ref 0. and found = ref 0 in
  let add e n =
    chi := !chi +. (((n -. e) ** 2.) /. e);
    incr bins
  in
  Array.iteri
    (fun c e ->
      let e = e *. float_of_int count in
      if e >= 20. then add e (float_of_int counts.(c))
      else (
        rest := !rest +. e;
        found := !found + counts.(c)))
    expected;
  (* Cells that hold little count together. *)
  if !rest >= 5. then add !rest (float_of_int !found)
  else if !found > 30 then
    Alcotest.failf "%s: %d where none should be" name !found;
  let freedom = float_of_int !bins in
  let z = (!chi -. freedom) /. sqrt (2. *. freedom) in
  if z > 6. then
    Alcotest.failf "%s: chi-square is %.1f deviations from its mean" name z

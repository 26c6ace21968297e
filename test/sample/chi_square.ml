(** Whether counts are as even as chance would have them. *)

(** [deviation counts] is how many standard deviations the chi-square statistic
    of [counts], all expected equal, is from its mean. *)
let deviation counts =
  let bins = Array.length counts in
  let expected =
    float_of_int (Array.fold_left ( + ) 0 counts) /. float_of_int bins
  in
  let term sum n = sum +. (((float_of_int n -. expected) ** 2.) /. expected) in
  let freedom = float_of_int (bins - 1) in
  (Array.fold_left term 0. counts -. freedom) /. sqrt (2. *. freedom)

(** [count bins cases bin] is how many of [0 .. cases - 1] are in each bin. *)
let count bins cases bin =
  let counts = Array.make bins 0 in
  for i = 0 to cases - 1 do
    let b = bin i in
    counts.(b) <- counts.(b) + 1
  done;
  counts

(** [even name counts] fails if the counts are too uneven: beyond 6 deviations,
    which chance does less than once in a million times; or too even. *)
let even name counts =
  let z = deviation counts in
  if z > 6. || (Array.length counts > 100 && z < -6.) then
    Alcotest.failf "%s: chi-square is %.1f deviations from its mean" name z

(** [against name expected counts] fails if [counts] are not what chance makes
    of [expected] (which need not add up to the same; it is scaled): beyond 6
    deviations, or anything at all where nothing is expected. Cells that expect
    fewer than 8 are taken together. *)
let against name expected counts =
  let cases = float_of_int (Array.fold_left ( + ) 0 counts) in
  let scale = cases /. Array.fold_left ( +. ) 0. expected in
  let term (sum, cells, few, few') (e, n) =
    let e = e *. scale and n = float_of_int n in
    if e = 0. && n > 0. then Alcotest.failf "%s: hits outside" name
    else if e < 8. then (sum, cells, few +. e, few' +. n)
    else (sum +. (((n -. e) ** 2.) /. e), cells + 1, few, few')
  in
  let sum, cells, few, few' =
    Array.fold_left term (0., 0, 0., 0.) (Array.combine expected counts)
  in
  let rare =
    if few > 0. then ((few' -. few) ** 2.) /. Float.max few 1. else 0.
  in
  let freedom = float_of_int (Int.max 1 (cells - if few > 0. then 0 else 1)) in
  let z = (sum +. rare -. freedom) /. sqrt (2. *. freedom) in
  if not (z < 6.) then
    Alcotest.failf "%s: chi-square is %.1f deviations from its mean" name z

open Price

let same (a : row) (b : row) = a.setting = b.setting && a.spp = b.spp
let is_knee p r = Option.fold ~none:false ~some:(same r) p.knee

let base p (r : row) =
  let samples (rung : row) = rung.spp = r.spp in
  List.find_opt samples p.ladder

let saving p (r : row) =
  let share (base : row) = 1. -. (r.measure.seconds /. base.measure.seconds) in
  match Option.map share (base p r) with
  | Some share when Float.is_finite share -> Some share
  | Some _ | None -> None

let halving (before : row) (r : row) =
  let halves = Float.log2 (before.measure.rms /. r.measure.rms) in
  let price = (r.measure.seconds -. before.measure.seconds) /. halves in
  if halves > 0. && Float.is_finite price && price > 0. then Some price
  else None

let per_halving p =
  let next (before, priced) r =
    let price = Option.bind before (fun before -> halving before r) in
    (Some r, (r, price) :: priced)
  in
  List.rev (snd (List.fold_left next (None, []) p.ladder))

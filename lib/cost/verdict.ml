type t = { loss : float; verdict : Price.verdict }

let shown = 0.5
let worthwhile = 0.01

let of_part (change : Pair.change) ~saved : Price.verdict =
  let hidden = change.bound < shown in
  if change.equal || (hidden && not change.shows) then Paid_for_nothing
  else if hidden && (not change.noisier) && saved >= worthwhile then Saves saved
  else Needed

let of_limit (change : Pair.change) ~saved : Price.verdict =
  if change.equal || change.bound < shown then Saves (Float.max 0. saved)
  else Needed

let of_sampler (change : Pair.change) ~law ~saved ~before ~after : Price.verdict
    =
  let b =
    match law with
    | Some { Power_law.b; _ } when b > 0. -> b
    | Some _ | None -> 0.5
  in
  let at_equal_error = (1. -. saved) *. ((after /. before) ** (1. /. b)) in
  let saved = 1. -. at_equal_error in
  if (change.noisier || change.quieter) && saved >= worthwhile then Saves saved
  else Needed

let wrong_pixels ~base p ~share : Price.verdict =
  let wrong = float_of_int (Pair.wrong ~base p) /. share in
  Wrong_pixels (int_of_float (Float.round wrong))

let v (setting : Price.setting) ~law ~finest ~base p ~share ~saved =
  let change = Pair.change ~base p in
  let loss verdict = { loss = change.loss; verdict } in
  match setting with
  | Samples _ -> { loss = 0.; verdict = Rung }
  | Depth _ | Cutoff _ -> loss (of_limit change ~saved)
  | Without_light _ | Without_effect _ -> loss (of_part change ~saved)
  | Naive_math -> loss (wrong_pixels ~base p ~share)
  | Sampler _ ->
      let before = (Pair.error ~finest base).rms
      and after = (Pair.error ~finest p).rms in
      {
        loss = after -. before;
        verdict = of_sampler change ~law ~saved ~before ~after;
      }

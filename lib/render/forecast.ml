type t = { taken : float; total : float; low : float; high : float }

(* By how much the number of samples is in doubt if the error is. *)
let spread ~law s =
  match (Sampling.rms s, Sampling.interval ~confidence:0.95 s) with
  | Some rms, Some { high; _ } when rms > 0. -> (high /. rms) ** (2. /. law)
  | (Some _ | None), (Some _ | None) -> 2.

let v ~taken ~total ~low ~high =
  let total = Float.max taken total in
  {
    taken;
    total;
    low = Float.min total (Float.max taken low);
    high = Float.max total high;
  }

(* Independent samples have law 1, those that fill their space evenly more. *)
let typical = 1.25

(* Before the law was measured it may be almost any, and the least samples often
   miss what makes the error: so the total is more likely larger than they say
   than smaller. *)
let for_error ~law s ~taken total =
  let reckoned = Option.value law ~default:1. in
  let spread = spread ~law:reckoned s in
  let by law =
    if total > taken && taken > 0. then
      taken *. ((total /. taken) ** (reckoned /. law))
    else total
  in
  match law with
  | Some law ->
      let flat = Float.max 1. (law -. 0.25) in
      v ~taken ~total:(by law)
        ~low:(by (law +. 0.25) /. spread)
        ~high:(by flat *. spread)
  | None ->
      v ~taken ~total:(by typical)
        ~low:(by 2. /. spread)
        ~high:(by 1. *. (spread ** 3.))

let for_time s ~taken total =
  let spread = spread ~law:1. s in
  v ~taken ~total ~low:(total /. spread) ~high:(total *. spread)

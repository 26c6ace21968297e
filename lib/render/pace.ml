type t = { share : float; low : float; high : float }

let sure share = { share; low = share; high = share }
let clamp x = Float.max 0. (Float.min 1. x)

let of_parts ~count ~seconds =
  let k = List.length seconds in
  if k = 0 then { share = 0.; low = 0.; high = 1. }
  else
    let n = float_of_int k and all = float_of_int count in
    let share = n /. all in
    let sum = List.fold_left ( +. ) 0. seconds in
    let mean = sum /. n in
    let square d = d *. d in
    let squares =
      List.fold_left (fun s x -> s +. square (x -. mean)) 0. seconds
    in
    if k < 2 || k >= count || sum = 0. then
      { share; low = (if k >= count then share else 0.); high = 1. }
    else
      (* The mean of the others differs from that of these by this deviation. *)
      let deviation =
        sqrt (squares /. (n -. 1.) *. ((1. /. n) +. (1. /. (all -. n))))
      in
      let share_if mean_of_others =
        clamp (sum /. (sum +. ((all -. n) *. Float.max 0. mean_of_others)))
      in
      {
        share;
        low = Float.min share (share_if (mean +. (2. *. deviation)));
        high = Float.max share (share_if (mean -. (2. *. deviation)));
      }

let of_forecast ~taken (f : Forecast.t) =
  let of_total total = if total > 0. then clamp (taken /. total) else 0. in
  { share = of_total f.total; low = of_total f.high; high = of_total f.low }

let time_left p ~elapsed =
  let left share =
    if share > 0. then elapsed *. (1. -. share) /. share else infinity
  in
  (left p.share, left p.high, left p.low)

(* The mean is mean + tail; squares is the sum of (x - mean)^2. *)
type t = { count : float; mean : float; tail : float; squares : float }

let empty = { count = 0.; mean = 0.; tail = 0.; squares = 0. }

(* [v] and [count] more samples, whose mean is [off] from that of [v] and whose
   squares about their own mean add up to [squares]. *)
let grown v off ~count ~squares =
  let all = v.count +. count in
  let step = off *. (count /. all) in
  let mean = Double_double.(add { hi = v.mean; lo = v.tail } (of_float step)) in
  {
    count = all;
    mean = mean.hi;
    tail = mean.lo;
    squares = v.squares +. squares +. (off *. (step *. v.count));
  }

let add v x = grown v (x -. v.mean -. v.tail) ~count:1. ~squares:0.

let join a b =
  if b.count = 0. then a
  else
    let off = b.mean -. a.mean +. (b.tail -. a.tail) in
    grown a off ~count:b.count ~squares:b.squares

let count v = int_of_float v.count
let mean v = if v.count = 0. then None else Some v.mean

let variance v =
  if v.count < 2. then None else Some (v.squares /. (v.count -. 1.))

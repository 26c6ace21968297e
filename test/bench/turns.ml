(* What is timed turn by turn, so that a machine that is busy for a while is so
   for all. *)

let median xs =
  let sorted = List.sort Float.compare xs in
  List.nth sorted (List.length sorted / 2)

(** [processor f] is what [f ()] took of one processor, in seconds, and what it
    made. *)
let processor f =
  let start = Sys.time () in
  let x = f () in
  (Sys.time () -. start, x)

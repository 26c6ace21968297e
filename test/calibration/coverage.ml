(* How often the error of a render with a fixed number of samples is where its
   own samples say it is. *)

open Candor_number
open Candor_render

type t = {
  name : string;
  spp : int;
  runs : (Sampling.t * float) list;  (** with the true error of each *)
}

let promised = [ 0.68; 0.95; 0.99 ]

(** [v truth case spp] is as many runs as there are seeds. *)
let v truth (case : Case.t) spp =
  let run seed =
    let results = Shot.uniform case.scene seed spp in
    (Shot.sampling results, Truth.error truth results)
  in
  let runs = Parallel.map run (List.init Case.runs Fun.id) in
  { name = case.name; spp; runs }

let is_inside ~confidence (sampling, error) =
  match Sampling.interval ~confidence sampling with
  | Some { low; high } -> low <= error && error <= high
  | None -> false

let count c = List.length c.runs

(** [inside c ~confidence] is how many errors lie in their intervals. *)
let inside c ~confidence =
  List.length (List.filter (is_inside ~confidence) c.runs)

(** [p_value c ~confidence] is that of so many, or of something rarer. *)
let p_value c ~confidence =
  Binomial.test ~successes:(inside c ~confidence) (count c) confidence

(** [pooled cs ~confidence] is the share of all runs of [cs]. *)
let pooled cs ~confidence =
  let sum f = List.fold_left (fun n c -> n + f c) 0 cs in
  float_of_int (sum (inside ~confidence)) /. float_of_int (sum count)

let root_mean_square xs =
  let square sum x = sum +. (x *. x) in
  sqrt (List.fold_left square 0. xs /. float_of_int (List.length xs))

(** [error c] is the RMS error over all runs. *)
let error c = root_mean_square (List.map snd c.runs)

(** [said c] is what they say it is. *)
let said c =
  root_mean_square (List.filter_map (fun (s, _) -> Sampling.rms s) c.runs)

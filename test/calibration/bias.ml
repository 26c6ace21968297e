(* Whether renders that stop when they are good enough are right on average. *)

open Candor_number
open Candor_render

type t = {
  name : string;
  width : int;
  height : int;
  error : float;  (** that renders stop at *)
  samples : float;  (** they take, on average, for each pixel *)
  least : float;
  most : float;  (** that single renders take for each pixel *)
  rms_z : float;
      (** of the values of single pixels, over all: 1 if there is no bias *)
  z : float;  (** of the mean of all values: normal if there is no bias *)
}

(* Ten for each seed of the other tables. *)
let runs = 10 * Case.runs

(* The finer picture: so many renders with so many samples. *)
let parts = 64
let part_spp = 512
let first_seed = 2_000_000

let adaptive scene ~error seed =
  let shot = Shot.make scene seed in
  Shot.adaptive shot (Aim.target ~error ~confidence:0.95) ~pass:ignore
  |> Option.map (fun (o : Adaptive.outcome) ->
      (Shot.linear o.results, Shot.samples shot))

(* Of all values at one place of many pictures. *)
let at pictures i =
  let add v p = Running_variance.add v (Float.Array.get p i) in
  List.fold_left add Running_variance.empty pictures

let mean_of_all picture =
  Float.Array.fold_left ( +. ) 0. picture
  /. float_of_int (Float.Array.length picture)

(* Not a number where chance plays no part and nothing differs. *)
let z a b =
  let mean v = Option.value (Running_variance.mean v) ~default:nan in
  let of_mean v =
    Option.value (Running_variance.variance v) ~default:nan
    /. float_of_int (Running_variance.count v)
  in
  let variance = of_mean a +. of_mean b in
  (mean a -. mean b) /. sqrt variance

let z_of_means a b =
  let whole pictures =
    at (List.map (fun p -> Float.Array.make 1 (mean_of_all p)) pictures) 0
  in
  z (whole a) (whole b)

let v (name, width, height) =
  let scene = Case.sized ~width ~height name in
  let render spp seed = Shot.uniform scene seed spp in
  let error =
    let one seed = Sampling.rms (Shot.sampling (render 16 seed)) in
    let some = List.filter_map one (List.init 16 (( + ) first_seed)) in
    0.7 *. Coverage.root_mean_square some
  in
  let fine =
    Parallel.map
      (fun seed -> Shot.linear (render part_spp seed))
      (List.init parts (( + ) first_seed))
  in
  let found =
    Parallel.map (adaptive scene ~error) (List.init runs Fun.id)
    |> List.filter_map Fun.id
  in
  let pictures = List.map fst found in
  let per_pixel n = float_of_int n /. float_of_int (width * height) in
  let samples = List.map (fun (_, n) -> per_pixel n) found in
  let values = List.init (3 * width * height) Fun.id in
  {
    name;
    width;
    height;
    error;
    samples =
      List.fold_left ( +. ) 0. samples /. float_of_int (List.length samples);
    least = List.fold_left Float.min infinity samples;
    most = List.fold_left Float.max 0. samples;
    rms_z =
      List.map (fun i -> z (at pictures i) (at fine i)) values
      |> List.filter (fun z -> not (Float.is_nan z))
      |> Coverage.root_mean_square;
    z = z_of_means pictures fine;
  }

let all () =
  List.map v
    [
      ("cornell", 12, 9);
      ("shadows", 12, 9);
      ("caustics", 12, 9);
      ("caustics", 24, 18);
    ]

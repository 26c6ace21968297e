open Candor_scene
open Candor_effect

(* Lights have few names: the line tells them apart. *)
let line (place : Place.t) =
  if Place.equal place Place.unknown then ""
  else Printf.sprintf ", line %d" place.line

let setting : Price.setting -> string = function
  | Samples n -> Amount.count n "sample"
  | Depth n -> Printf.sprintf "depth %d" n
  | Cutoff w -> "cut-off " ^ Amount.number w
  | Sampler s -> Candor_sample.Sampler.name s ^ " sampler"
  | Without_light { name; place } -> "without " ^ name ^ line place
  | Without_effect { absent; _ } -> "without " ^ Effect.name absent
  | Naive_math -> "naive math"

let worth share = share >= 0.01

let key i =
  let letter = String.make 1 (Char.chr (Char.code 'a' + (i mod 26))) in
  if i < 26 then letter else letter ^ string_of_int (i / 26)

(* Samplers all make the same picture in the mean: they are judged by the time
   to the same error. *)
let verdict (r : Price.row) =
  match (r.verdict, r.setting) with
  | Rung, _ -> None
  | Needed, Sampler _ -> Some "no better"
  | Needed, _ -> Some "needed"
  | Saves share, Sampler _ ->
      Some ("saves " ^ Amount.percent share ^ " at equal error")
  | Saves share, _ -> Some ("saves " ^ Amount.percent share)
  | Paid_for_nothing, _ -> Some "paid for nothing"
  | Wrong_pixels 0, _ -> Some "no wrong pixel"
  | Wrong_pixels n, _ -> Some (Amount.count n "wrong pixel")

let known (_, place) = not (Place.equal place Place.unknown)

let places : Price.setting -> _ = function
  | Without_light { name; place } -> List.filter known [ (name, place) ]
  | Without_effect { reasons; _ } ->
      List.map (fun (r : Reason.t) -> (r.what, r.place)) reasons
      |> List.filter known
  | Samples _ | Depth _ | Cutoff _ | Sampler _ | Naive_math -> []

let rms e = Amount.error e ^ "/255"

open Candor_colour
open Candor_scene
open Candor_effect
open Candor_image

type t = At_most of float | Unbounded of string [@@deriving show, eq]

let lost x most =
  let shown = Display.encode x in
  (* Written so that nan is as bad as can be. *)
  if most >= 0. then Display.encode (x +. most) -. shown else 255.

let squares ~(most : Rgb.t) ~(cut : Rgb.t) (mean : Rgb.t) =
  if Rgb.is_black cut then 0.
  else
    let r = lost mean.r (most.r *. cut.r)
    and g = lost mean.g (most.g *. cut.g)
    and b = lost mean.b (most.b *. cut.b) in
    (r *. r) +. (g *. g) +. (b *. b)

let of_squares ~pixels squares =
  At_most (sqrt (squares /. float_of_int (3 * pixels)))

let sum_of_squares most ~cut picture =
  let width = Picture.width picture in
  let pixels = width * Picture.height picture in
  let one i =
    let x = i mod width and y = i / width in
    squares ~most ~cut:(Picture.pixel cut x y) (Picture.pixel picture x y)
  in
  let all = Seq.map one (Seq.take pixels (Seq.ints 0)) in
  of_squares ~pixels (Seq.fold_left ( +. ) 0. all)

let of_picture (brightest : Brightest.t) ~cut picture =
  match brightest with
  | Unbounded why -> Unbounded why
  | At_most most -> sum_of_squares most ~cut picture

(* {1 In the ledger} *)

let cuts = [ Tally.Cut_by_depth; Cut_by_weight ]
let is_whole tally = List.for_all (fun c -> Tally.get tally c = 0) cuts

let ended (s : Scene.t) tally =
  [
    (Tally.Cut_by_depth, Printf.sprintf "ended at depth %d" (Scene.depth s));
    (Cut_by_weight, Printf.sprintf "fell below weight %g" s.settings.cutoff);
  ]
  |> List.map (fun (counter, why) -> (Tally.get tally counter, why))
  |> List.filter (fun (n, _) -> n > 0)
  |> List.map (fun (n, why) -> Plural.count n "path" ^ " " ^ why)
  |> String.concat ", "

(* To two digits after the point, never down. *)
let rounded_up x = Float.ceil (x *. 100.) /. 100.

let text scene tally bound =
  if is_whole tally then "0: no path was cut"
  else
    match Lazy.force bound with
    | At_most rms ->
        Printf.sprintf "<= %.2f/255   %s" (rounded_up rms) (ended scene tally)
    | Unbounded why ->
        Printf.sprintf "unbounded: %s; %s" (ended scene tally) why

let json tally bound =
  let cut c = Json.Int (Tally.get tally c) in
  let rms, reason =
    match if is_whole tally then At_most 0. else Lazy.force bound with
    | At_most rms -> (Json.Float rms, [])
    | Unbounded why -> (Null, [ ("reason", Json.String why) ])
  in
  Json.Object
    ((("rms", rms) :: reason)
    @ [ ("by_depth", cut Cut_by_depth); ("by_weight", cut Cut_by_weight) ])

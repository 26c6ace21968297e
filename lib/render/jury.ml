type fate = Going | Stopped of { met : bool }

type t = {
  are_together : bool;
  fates : fate array; (* of the parts *)
  kept : Row.result array option; (* since the first of them stopped *)
}

let fewest = 100

let start window =
  let fate part =
    if Part.is_in window part then Going else Stopped { met = true }
  in
  {
    are_together = Window.width window * Window.height window < fewest;
    fates = Array.init Part.count fate;
    kept = None;
  }

let goes_on = function Going -> true | Stopped _ -> false
let is_done j = not (Array.exists goes_on j.fates)

let all_met j =
  Array.for_all (function Going -> false | Stopped { met } -> met) j.fates

let judges j part = if j.are_together then Part.all else Part.judges part

let is_needed j part =
  let asks other fate = goes_on fate && List.mem part (judges j other) in
  goes_on j.fates.(part) || Array.exists Fun.id (Array.mapi asks j.fates)

(* {1 What samples say} *)

let of_parts rows =
  let of_part part = Sampling.sum (fun row -> Row.of_part row part) rows in
  Array.init Part.count of_part

let sampling rows = Sampling.sum Fun.id (of_parts rows)

let is_small_enough ~error ~confidence sampling =
  match (error, Sampling.cautious ~confidence sampling) with
  | Some error, Some bound -> bound <= error
  | Some _, None | None, (Some _ | None) -> false

(* A pixel that is not finite stays so. (Those that it does not judge go on: it
   has no say in how many samples they have.) *)
let is_hopeless ~error sampling =
  Option.is_some error && Sampling.tells_nothing sampling

(* {1 Judgement} *)

let results rows j =
  let now = Array.map Row.result rows in
  let is_settled part = not (goes_on j.fates.(part)) in
  match j.kept with
  | None -> now
  | Some before ->
      Array.mapi
        (fun i row -> Row.merge row ~is_settled before.(i) now.(i))
        rows

let judge ~error ~confidence ~full rows j =
  let said = of_parts rows in
  (* Who are judged together end together. *)
  let is_full part =
    if j.are_together then Array.for_all Fun.id full else full.(part)
  in
  let of_part part = function
    | Stopped _ as fate -> fate
    | Going ->
        let judges = Array.of_list (judges j part) in
        let sampling = Sampling.sum (fun judge -> said.(judge)) judges in
        let met = is_small_enough ~error ~confidence sampling in
        if met || is_full part || is_hopeless ~error sampling then
          Stopped { met }
        else Going
  in
  let fates = Array.mapi of_part j.fates in
  if fates = j.fates then j else { j with fates; kept = Some (results rows j) }

type t = Independent | Stratified | Sobol [@@deriving show, eq, ord]

let all = [ Independent; Stratified; Sobol ]

let name = function
  | Independent -> "independent"
  | Stratified -> "stratified"
  | Sobol -> "sobol"

let streams = 4

let[@inline] stream sampler sample =
  match sampler with
  | Sobol -> sample mod streams
  | Independent | Stratified -> sample

let[@inline] index sampler sample =
  match sampler with Sobol -> sample / streams | Independent | Stratified -> 0

let centre = { Pattern.u = 0.5; v = 0.5 }

let own sampler ~seed ~x ~y sample =
  let key = Key.v ~seed ~x ~y ~sample:(stream sampler sample) ~bounce:0 Film in
  Sobol.pair ~key (index sampler sample)

let stratified ~seed ~spp =
  let pattern stream =
    let key = Key.v ~seed ~x:0 ~y:0 ~sample:stream ~bounce:0 Film in
    Pattern.make ~seed:(key :> int) ~spp:((spp + streams - 1) / streams)
  in
  let patterns = Array.init streams pattern in
  fun ~x ~y sample ->
    Pattern.position patterns.(sample mod streams) ~x ~y (sample / streams)

let film sampler ~seed ~spp =
  if spp = 1 then fun ~x:_ ~y:_ _ -> centre
  else
    match sampler with
    | Stratified -> stratified ~seed ~spp
    | Independent | Sobol -> own sampler ~seed

open Candor_space

type t =
  | Outermost
  | Within of { index : int; transform : Transform.t option; around : t }
  | Moved of { by : Vec.t; around : t }

let path way place =
  let rec lead way path =
    match way with
    | Outermost -> path
    | Within { index; around; _ } -> lead around (index :: path)
    | Moved { around; _ } -> lead around path
  in
  lead way [ place ]

open Candor_cost
open Candor_oracle
open QCheck2

let valid x =
  match float_of_string_opt (Svg.number x) with
  | Some n -> Float.is_finite n && Float.abs n <= 1e6
  | None -> false

let near x =
  (not (Float.abs x < 1e6))
  || Float.abs (float_of_string (Svg.number x) -. x) <= 0.051

let suite =
  ( "drawings",
    [
      Law.law ~print:Print.float "every coordinate is a number of modest size"
        Hostile.number valid;
      Law.law ~print:Print.float "to a tenth of a unit" Hostile.number near;
    ] )

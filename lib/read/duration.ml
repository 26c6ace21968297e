let units = [ ("s", 1.); ("m", 60.); ("h", 3600.) ]

let parts text =
  let with_unit (suffix, seconds) =
    if String.ends_with ~suffix text then
      let digits = String.length text - String.length suffix in
      Some (String.sub text 0 digits, seconds)
    else None
  in
  Option.value (List.find_map with_unit units) ~default:(text, 1.)

let of_string text =
  let number, unit = parts text in
  match Number.of_string number with
  | Ok n when n > 0. && Float.is_finite (n *. unit) -> Ok (n *. unit)
  | Ok _ | Error _ -> Error "expected a time above 0, such as 20s or 1.5m"

let to_string t = Number.to_string t ^ "s"

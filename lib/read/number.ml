let is_digit = function
  | '0' .. '9' | 'a' .. 'f' | 'A' .. 'F' | 'x' | 'X' | 'p' | 'P' -> true
  | '+' | '-' | '.' -> true
  | _ -> false

(* Leaves out what [float_of_string] allows besides: nan, infinity, blanks and
   underscores. *)
let of_string s =
  match float_of_string_opt s with
  | Some x when String.for_all is_digit s ->
      if Float.is_finite x then Ok x
      else Error (Printf.sprintf "%s is too large for a number" (Quote.word s))
  | Some _ | None -> Error (Printf.sprintf "%s is not a number" (Quote.word s))

let is_meant s =
  match s with
  | "" -> false
  | _ -> (
      match s.[0] with
      | '0' .. '9' | '+' | '-' | '.' -> true
      | _ -> Option.is_some (float_of_string_opt s))

let to_string x =
  let reads s =
    Int64.equal
      (Int64.bits_of_float (float_of_string s))
      (Int64.bits_of_float x)
  in
  let digits n = Printf.sprintf "%.*g" n x in
  match List.find_opt reads [ digits 15; digits 16 ] with
  | Some s -> s
  | None -> digits 17

open Decode

let number ?hint rule called =
  atom
    ~expected:(fun () -> "a number")
    (fun notes span a ->
      match Number.of_string a with
      | Error why -> Notes.refuse notes span ?hint why
      | Ok x -> (
          match Rule.broken rule x with
          | None -> Some x
          | Some must ->
              Notes.refuse notes span
                (Printf.sprintf "%s %s, but is %s" (called ()) must
                   (Quote.word a))))

let numbers arguments rule = several arguments (number rule)
let scalar argument rule = numbers argument rule |> map (fun a -> a.(0))

let is_whole a =
  let is_digit = function '0' .. '9' -> true | _ -> false in
  match String.split_on_char '-' a with
  | [ digits ] | [ ""; digits ] ->
      (not (String.equal digits "")) && String.for_all is_digit digits
  | [] | _ :: _ -> false

let whole_number ~min ~max called =
  atom
    ~expected:(fun () -> "a whole number")
    (fun notes span a ->
      match int_of_string_opt a with
      | Some n when is_whole a && min <= n && n <= max -> Some n
      | Some _ | None ->
          Notes.refuse notes span
            (if is_whole a then
               Printf.sprintf "%s must be from %d to %d, but is %s" (called ())
                 min max (Quote.word a)
             else Quote.word a ^ " is not a whole number"))

let wholes arguments ~min ~max = several arguments (whole_number ~min ~max)
let whole argument ~min ~max = wholes argument ~min ~max |> map (fun a -> a.(0))

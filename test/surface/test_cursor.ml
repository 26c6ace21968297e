open Candor_surface
open Candor_oracle
open QCheck2

let time =
  Gen.oneof
    [
      Draw.small 3;
      Draw.any_coordinate;
      Draw.pick [ infinity; neg_infinity; nan; max_float; 0.; -0.; 5e-324 ];
    ]

let contact = Contact.v ~part:3 Inside

let takes (limit, t) =
  let cursor = Cursor.v limit in
  let found = Cursor.take cursor t contact in
  (* In the order of Float.compare nan comes first, and 0 equals -0. *)
  let wanted =
    Float.is_finite t && Float.compare t 0. > 0 && Float.compare t limit <= 0
  in
  if wanted then found = contact && Float.equal cursor.t t
  else found = Contact.none && Float.equal cursor.t limit

(* Of several the least is kept, and of those that tie the last. *)
let keeps_least (limit, times) =
  let cursor = Cursor.v limit in
  let take kept (i, t) =
    let found = Cursor.take cursor t (Contact.v ~part:i Outside) in
    if Contact.is_none found then kept else found
  in
  let numbered = List.mapi (fun i t -> (i, t)) times in
  let kept = List.fold_left take Contact.none numbered in
  let hits = List.filter (fun (_, t) -> t > 0. && t <= limit) numbered in
  let least = List.fold_left (fun m (_, t) -> Float.min m t) limit hits in
  match List.rev (List.filter (fun (_, t) -> t = least) hits) with
  | [] -> Contact.is_none kept && cursor.t = limit
  | (last, _) :: _ ->
      (not (Contact.is_none kept))
      && Contact.part kept = last
      && cursor.t = least

let show_time = Printf.sprintf "%h"

let suite =
  ( "cursor",
    [
      Law.law ~count:10000
        ~print:(fun (limit, t) -> Printf.sprintf "%h within %h" t limit)
        "it takes a finite t with 0 < t <= its own and moves there, and no \
         other"
        Gen.(
          let* limit = time in
          let* t = oneof [ time; return limit; return (Float.succ limit) ] in
          return (limit, t))
        takes;
      Law.law
        ~print:(fun (limit, times) ->
          String.concat " " (show_time limit :: "<-" :: List.map show_time times))
        "after several it is at the least, ties to the last"
        Gen.(
          pair
            (oneof [ return infinity; map Float.abs (Draw.small 4) ])
            (list_size (int_bound 12) (Draw.small 5)))
        keeps_least;
    ] )

open Candor_space
open Candor_surface
open Candor_oracle
open QCheck2

(* Parts up to the largest that fits. *)
let part =
  Gen.oneof
    [
      Gen.int_bound 6; Gen.int_bound (max_int / 2); Draw.pick [ 0; max_int / 2 ];
    ]

let side = Draw.pick [ Side.Outside; Side.Inside ]
let contact = Gen.pair part side
let show (part, side) = Printf.sprintf "part %d, %s" part (Side.show side)
let pack (part, side) = Contact.v ~part side

let unpacks (part, side) =
  let c = pack (part, side) in
  Contact.part c = part
  && Side.equal (Contact.side c) side
  && not (Contact.is_none c)

let tells_apart (a, b) = pack a <> pack b || a = b
let immediate c = Obj.is_int (Obj.repr (pack c))

let none () =
  Alcotest.(check bool) "none is none" true (Contact.is_none Contact.none)

let law name gen print holds = Law.law ~print name gen holds

let suite =
  ( "contact",
    [
      law "what is packed is unpacked, and is not none" contact show unpacks;
      law "different contacts are different"
        Gen.(
          let* a = contact in
          let* b = oneof [ contact; map (fun s -> (fst a, s)) side ] in
          return (a, b))
        (fun (a, b) -> show a ^ " and " ^ show b)
        tells_apart;
      law "a contact is an immediate integer" contact show immediate;
      Law.example "none is no contact" none;
    ] )

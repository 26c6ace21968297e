open Candor_read
open Text

let check rule x expected =
  Alcotest.(check (option string))
    (string_of_float x) expected (Rule.broken rule x)

let ends () =
  let out = Some "must be from 0 to 1" in
  let share = Rule.within 0. 1. in
  check share 0. None;
  check share 1. None;
  check share (Float.succ 1.) out;
  check share (-0x1p-1074) out;
  let open_ = Rule.between 0. 180. in
  check open_ 0. (Some "must be above 0 and below 180");
  check open_ 180. (Some "must be above 0 and below 180");
  check open_ 0x1p-1074 None

let sizes () =
  check Rule.size 0. (Some "must be above 0");
  check Rule.size (-1.) (Some "must be above 0");
  check Rule.size 0x1p-401 (Some "must be at least 2^-400");
  check Rule.size 0x1p-400 None;
  check Rule.size 0x1p400 None;
  check Rule.size (Float.succ 0x1p400) (Some "must be at most 2^400");
  check Rule.length (-0x1p400) None;
  check Rule.length (Float.pred (-0x1p400))
    (Some "must be at most 2^400 in size");
  check Rule.any 0x1p1000 None;
  check Rule.not_negative (-0.) None

let suite =
  ( "rule",
    [
      case "closed ends belong to a range and open ones do not" ends;
      case "the first broken condition is told" sizes;
    ] )

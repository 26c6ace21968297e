open Candor_cost
open Candor_oracle

let check name expected actual = Alcotest.(check string) name expected actual

(* With spaces that do not break, all of them or those before units. *)
let spaced s = String.concat "\u{a0}" (String.split_on_char ' ' s)

let unit_spaced s =
  let words = String.split_on_char ' ' s in
  let unit w = List.mem w [ "s"; "min"; "h" ] in
  String.concat ""
    (List.mapi
       (fun i w -> (if i = 0 then "" else if unit w then "\u{a0}" else " ") ^ w)
       words)

let numbers () =
  let is expected x = check expected expected (Amount.number x) in
  is "0" 0.;
  is "0.71" 0.71;
  is "9.21" 9.21;
  is "25.3" 25.3;
  is "943" 943.2;
  is "−3.00" (-3.);
  is "0.0012" 0.0012;
  is "1.2·10⁻⁵" 1.2e-5;
  is "3.0·10²⁰" 3e20;
  is "∞" infinity;
  is "−∞" neg_infinity;
  is "—" nan

let times () =
  let is expected s = check expected (spaced expected) (Amount.seconds s) in
  is "0 s" 0.;
  is "12 µs" 12.3e-6;
  is "3.2 ms" 0.0032;
  is "0.41 s" 0.412;
  is "4.9 s" 4.9;
  is "5 s" 5.;
  is "14 s" 14.2;
  is "1 min" 60.;
  is "17 min" 1018.;
  is "1.1 h" 3960.;
  is "4.2 days" 363000.;
  is "1.2·10¹⁵ days" 1e20;
  is "−0.60 s" (-0.6);
  is "∞" infinity;
  is "—" nan

let ranges () =
  let is expected low high =
    check expected (unit_spaced expected) (Amount.range low high)
  in
  is "12 to 17 s" 12. 17.;
  is "51 min to 1.3 h" 3060. 4700.;
  is "12 s to ∞" 12. infinity;
  is "— to —" nan nan

let others () =
  check "an error" "<0.001" (Amount.error 0.0002);
  check "a half" "½" (Amount.target 0.5);
  check "a whole" "4" (Amount.target 4.);
  check "next to nothing" "<0.001" (Amount.change Amount.error (-0.0002));
  check "more" "+0.02" (Amount.change Amount.error 0.02);
  check "less" "−0.02" (Amount.change Amount.error (-0.02));
  check "as much" "0" (Amount.change Amount.error 0.);
  check "a share" "12\u{a0}%" (Amount.percent 0.12);
  check "one" "1 sample" (Amount.count 1 "sample");
  check "many" "17\u{202f}342 samples" (Amount.count 17342 "sample");
  check "hundreds" "−100" (Amount.whole (-100))

let suite =
  ( "amounts",
    [
      Law.example "numbers have about three digits" numbers;
      Law.example "times have a unit" times;
      Law.example "a range names one unit once" ranges;
      Law.example "errors, changes, shares and counts" others;
    ] )

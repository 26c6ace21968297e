open Candor_render
open Candor_oracle
open QCheck2

let never () = false
let domains = Gen.int_range 1 6

let law name f =
  let print (d, n) = Printf.sprintf "%d domains, %d rows" d n in
  Law.law ~count:30 ~print name (Gen.pair domains (Gen.int_bound 300)) f

let f i = (i * i, string_of_int i)

let is_init (domains, n) =
  Rows.parallel ~domains ~stop:never n f = Array.init n (fun i -> Some (f i))

let once (domains, n) =
  let calls = Array.init n (fun _ -> Atomic.make 0) in
  ignore
    (Rows.parallel ~domains ~stop:never n (fun i -> Atomic.incr calls.(i))
      : unit option array);
  Array.for_all (fun c -> Atomic.get c = 1) calls

(* What was begun before the stop is done, the rest is not begun. *)
let stops (domains, n) =
  let begun = Atomic.make 0 in
  let stop () = Atomic.get begun >= 7 in
  let rows =
    Rows.parallel ~domains ~stop n (fun i ->
        Atomic.incr begun;
        i)
  in
  let done_ = List.filter_map Fun.id (Array.to_list rows) in
  List.length done_ = Atomic.get begun
  && Atomic.get begun <= 7 + domains
  && Array.for_all2
       (fun row i -> match row with None -> true | Some r -> r = i)
       rows (Array.init n Fun.id)

let stopped_before () =
  let rows =
    Rows.parallel ~domains:3
      ~stop:(fun () -> true)
      20
      (fun _ -> Alcotest.fail "a row was begun")
  in
  Alcotest.(check bool) "no row" true (Array.for_all Option.is_none rows)

exception Broken

let raises () =
  Alcotest.check_raises "the exception of a row" Broken (fun () ->
      ignore
        (Rows.parallel ~domains:3 ~stop:never 20 (fun i ->
             if i = 11 then raise Broken)
          : unit option array));
  Alcotest.(check bool) "and the next picture is fine" true (is_init (3, 20))

let machine () =
  Alcotest.(check bool) "at least one" true (Rows.most_domains () >= 1)

let suite =
  ( "rows in parallel",
    [
      law "parallel is Array.init for any number of domains" is_init;
      law "every row is done once" once;
      law "no row is begun after the stop" stops;
      Law.example "nothing is done when stopped from the start" stopped_before;
      Law.example "what a row raises comes through" raises;
      Law.example "this machine runs some domain" machine;
    ] )

open Domainslib

let most_domains () = Domain.recommended_domain_count ()

(* When one domain's minor heap is full all domains stop, so it should not be
   small; nor larger than a cache, or every allocation misses it. In words. *)
let minor_heap = 1 lsl 20

(* Gc.set in one domain does not reach the others: each does it once. *)
let sized =
  Domain.DLS.new_key (fun () ->
      let gc = Gc.get () in
      if gc.minor_heap_size < minor_heap then
        Gc.set { gc with minor_heap_size = minor_heap })

let rec gcd a b = if b = 0 then a else gcd b (a mod b)

(* Steps of about n/φ visit all n rows, and any number of the first of them all
   parts of the picture alike: what they took tells what the others will. *)
let stride n =
  let rec coprime k = if gcd k n = 1 then k else coprime (k + 1) in
  coprime (Int.max 1 (int_of_float (0.618 *. float_of_int n)))

let parallel ~domains ~stop n f =
  let rows = Array.make n None in
  let stride = stride n in
  let row k =
    let i = k * stride mod n in
    Domain.DLS.get sized;
    if not (stop ()) then rows.(i) <- Some (f i)
  in
  let pool = Task.setup_pool ~num_domains:(domains - 1) () in
  Fun.protect
    ~finally:(fun () -> Task.teardown_pool pool)
    (fun () ->
      Task.run pool (fun () ->
          Task.parallel_for ~chunk_size:1 ~start:0 ~finish:(n - 1) ~body:row
            pool));
  rows

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

let parallel ~domains ~stop n f =
  let rows = Array.make n None in
  let row i =
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

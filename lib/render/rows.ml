open Domainslib

let most_domains () = Domain.recommended_domain_count ()

let parallel ~domains ~stop n f =
  let rows = Array.make n None in
  let row i = if not (stop ()) then rows.(i) <- Some (f i) in
  let pool = Task.setup_pool ~num_domains:(domains - 1) () in
  Fun.protect
    ~finally:(fun () -> Task.teardown_pool pool)
    (fun () ->
      Task.run pool (fun () ->
          Task.parallel_for ~chunk_size:1 ~start:0 ~finish:(n - 1) ~body:row
            pool));
  rows

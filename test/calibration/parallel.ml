(* Jobs on all cores. *)

open Domainslib

(** [map f jobs] is [f] of each of [jobs], in their order. *)
let map f jobs =
  let jobs = Array.of_list jobs in
  let results = Array.map (fun _ -> None) jobs in
  let others = Domain.recommended_domain_count () - 1 in
  let pool = Task.setup_pool ~num_domains:others () in
  let body i = results.(i) <- Some (f jobs.(i)) in
  Task.run pool (fun () ->
      Task.parallel_for ~chunk_size:1 ~start:0
        ~finish:(Array.length jobs - 1)
        ~body pool);
  Task.teardown_pool pool;
  List.filter_map Fun.id (Array.to_list results)

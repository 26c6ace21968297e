open Candor_scene

type t = {
  material : Material.t;
  both_sides : bool;
  place : Place.t;
  lobes : Lobes.at;
}

let surface ?math scene =
  (* Local mutation: the lobes of materials met so far, and of the last, which
     most surfaces share with the one before. *)
  let met = Hashtbl.create 16 and last = ref None in
  let found material =
    match Hashtbl.find_opt met material with
    | Some lobes -> lobes
    | None ->
        let lobes = Lobes.compile material in
        Hashtbl.add met material lobes;
        lobes
  in
  let lobes material =
    match !last with
    | Some (m, lobes) when m == material -> lobes
    | Some _ | None ->
        let lobes = found material in
        last := Some (material, lobes);
        lobes
  in
  let dress { Assembly.material; both_sides; place } =
    { material; both_sides; place; lobes = lobes material }
  in
  Assembly.surface ?math ~dress scene

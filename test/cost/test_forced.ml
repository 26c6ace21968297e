(* An effect that nothing calls for can be had anyway, and changes nothing. *)

open Candor_effect
open Candor_oracle

(* With samples a pixel: one of them takes one, which calls for no
   anti-aliasing. *)
let scenes =
  [
    ("glazed-floor", 2);
    ("orthographic", 1);
    ("shadows", 2);
    ("cornell", 2);
    ("glass", 2);
  ]

let shots =
  let shot (name, spp) =
    let scene = Now.sized name ~width:24 ~height:18 ~spp in
    (name, scene, lazy (Now.digest (Now.render (Plan.of_scene scene) scene)))
  in
  List.map shot scenes

let check e (name, scene, least) =
  let forced = Now.digest (Now.render (Plan.forcing [ e ] scene) scene) in
  Alcotest.(check string) name (Lazy.force least) forced

let same_bits e () =
  let calls (_, scene, _) = Effect.calls e scene <> [] in
  let without = List.filter (fun s -> not (calls s)) shots in
  if without = [] then Alcotest.fail "every scene calls for it";
  List.iter (check e) without

let suite =
  ( "forced",
    List.map
      (fun e -> Law.example (Effect.name e ^ " alone: same bits") (same_bits e))
      Effect.all )

open Candor_space
open Candor_surface
open Candor_scene

(* No scene that people write has more surfaces one behind the other. *)
let most = 100_000

(* The bodies that a ray is in, of those entered on its way, and those that it
   turned out to start in, outermost first. *)
type state = { entered : Material.t list; around : Material.t list }

let crossed state (hit : Tracer.hit) =
  let m = hit.material.material in
  if not (Refraction.is_body m) then state
  else
    match hit.side with
    | Outside -> { state with entered = m :: state.entered }
    | Inside when List.memq m state.entered ->
        { state with entered = Refraction.without m state.entered }
    | Inside -> { state with around = m :: state.around }

(* Not a closure: it is asked for every camera ray where they start apart. *)
let rec leave (tracer : Tracer.t) tally path d n ray state =
  match tracer.nearest tally path ray with
  | Some hit when n < most -> (
      let state = crossed state hit in
      let place = Hit.place hit d in
      match Refraction.touching tracer tally path place with
      | None -> leave tracer tally path d (n + 1) (Hit.spawn hit d) state
      | Some other ->
          let state = crossed state other in
          let ray = Hit.spawn_clear other place d in
          leave tracer tally path d (n + 1) ray state)
  | Some _ | None -> state.around

let is_body (skin : Candor_optics.Skin.t) = Refraction.is_body skin.material

(* Most rays never come to a body. *)
let v (tracer : Tracer.t) path (ray : Ray.t) =
  let tally = Tally.make () in
  if tracer.meets_any tally path is_body ray then
    { entered = []; around = [] }
    |> leave tracer tally path ray.direction 0 ray
    |> List.rev
  else []

open Candor_space
open Candor_colour
open Candor_sample
open Candor_scene
open Candor_surface
open Candor_optics

let name = "indirect light"
let meaning = "light that bounces off surfaces is followed"

let calls (scene : Scene.t) =
  match scene.indirect with
  | Some place when Reason.receivers scene <> [] ->
      [ Reason.v "indirect light" place ]
  | Some _ | None -> []

let follow limit radiance tally
    ({ hit; lobes; path; _ } as vertex : Term.vertex) (s : Gloss.sample) =
  let survival =
    if Hit.faces hit (s.toward :> Vec.t) then
      Limit.survival limit tally path Key.Bounce ~weight:s.weight
        ~beside:lobes.mirror
    else 0.
  in
  if survival = 0. then Rgb.black
  else (
    Tally.count tally Bounce_rays;
    let weight = Rgb.scale survival s.weight in
    let arrival =
      Path.Spread { density = s.density; from = Receiver.vantage vertex }
    in
    let path =
      Path.onward path Key.Bounce
        (Rgb.mul path.throughput weight)
        { path.journey with arrival }
    in
    let ray = Hit.spawn_lit hit (s.toward :> Vec.t) in
    Rgb.mul weight (radiance tally ~kind:"bounce" path ray))

let term (scattering : Scattering.t) limit : Term.t =
 fun radiance tally ({ hit; view; lobes; path } as vertex) ->
  if scattering.is_black lobes then Rgb.black
  else
    let normal = hit.shading_normal in
    let view = Dir.of_vec_or normal view in
    (* Only gloss has lobes to choose from. *)
    let choice =
      if Option.is_some lobes.gloss then Path.one path Lobe else 0.
    in
    scattering.sample lobes ~normal ~view ~choice (Path.pair path Bounce)
    |> Option.fold ~none:Rgb.black ~some:(follow limit radiance tally vertex)

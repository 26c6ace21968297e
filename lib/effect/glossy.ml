open Candor_space
open Candor_colour
open Candor_sample
open Candor_surface
open Candor_optics

let name = "gloss"
let meaning = "rough metal and plastic blur what they reflect"
let calls = Reason.materials Lobes.glosses

let light_met veiled lights (tracer : Tracer.t) tally
    ({ hit; path; _ } as vertex : Term.vertex) (s : Gloss.sample) =
  if not (Hit.faces hit (s.toward :> Vec.t)) then Rgb.black
  else (
    Tally.count tally Emitter_rays;
    let arrival =
      Path.Spread { density = s.density; from = Receiver.vantage vertex }
    in
    let path = { path with journey = { path.journey with arrival } } in
    match tracer.nearest tally path (Hit.spawn_lit hit (s.toward :> Vec.t)) with
    | None -> Rgb.black
    | Some met ->
        let light = Emission.radiance met in
        if Rgb.is_black light then Rgb.black
        else
          let light = veiled path hit.point met.point light in
          Rgb.mul s.weight
            (Rgb.scale (Soft_shadows.weigh lights path met) light))

let term ?veil lights tracer : Term.t =
  let veiled = Soft_shadows.veiled veil in
  fun _ tally ({ hit; view; lobes; path } as vertex) ->
    match lobes.gloss with
    | None -> Rgb.black
    | Some gloss ->
        let normal = hit.shading_normal in
        let view = Dir.of_vec_or normal view in
        let { Pattern.u; v } = Path.pair path Bounce in
        Gloss.sample gloss ~normal ~view ~choice:(Path.one path Lobe) ~u ~v
        |> Option.fold ~none:Rgb.black
             ~some:(light_met veiled lights tracer tally vertex)

open Candor_space
open Candor_colour
open Candor_scene
open Candor_optics

let name = "sky light"
let meaning = "the bright parts of a background picture shine on surfaces"

let sky (scene : Scene.t) =
  match scene.background with
  | Image { texels; _ } -> Sampled_sky.make texels
  | Uniform _ | Gradient _ -> None

let is_picture (scene : Scene.t) =
  match scene.background with
  | Image { texels; _ } -> Texels.exists (fun c -> not (Rgb.is_black c)) texels
  | Uniform _ | Gradient _ -> false

let calls (scene : Scene.t) =
  match scene.indirect with
  | Some place when is_picture scene && Reason.receivers scene <> [] ->
      [ Reason.v "background picture under indirect light" place ]
  | Some _ | None -> []

let estimate ?veil sky (tracer : Tracer.t) : Direct.scattered =
  let veil : Direct.veil =
    match veil with Some veil -> veil | None -> fun _ _ _ -> Rgb.white
  in
  fun tally path (r : Receiver.t) ->
    let { Candor_sample.Pattern.u; v } = Path.pair path Sky_direction in
    match Sampled_sky.sample sky ~u ~v with
    | None -> Rgb.black
    | Some { direction; radiance; density } ->
        let response = r.respond direction in
        let d = (direction :> Vec.t) in
        if Rgb.is_black response then Rgb.black
        else (
          Tally.count tally Sky_rays;
          if tracer.blocked tally path ~limit:infinity (r.spawn d) then
            Rgb.black
          else
            let light = Rgb.mul (veil path r.vantage.from (Along d)) radiance
            and share = Receiver.power density (r.density direction) in
            Rgb.scale (share /. density) (Rgb.mul response light))

let weigh sky (path : Path.t) d =
  match (path.journey.arrival, Dir.of_vec d) with
  | Sharp, _ | _, None -> 1.
  | Spread { density; _ }, Some d ->
      Receiver.power density (Sampled_sky.density sky d)

let term = Receiver.lit

let radiance (scene : Scene.t) sky : Path.t -> Vec.t -> Rgb.t =
  let seen = Sky.compile scene.background in
  match sky with
  | None -> fun _ d -> seen d
  | Some sky -> fun path d -> Rgb.scale (weigh sky path d) (seen d)

open Candor_space
open Candor_colour
open Candor_scene
open Candor_optics

let name = "soft shadows"
let meaning = "surfaces that give light shine on others"

let calls scene =
  if Reason.receivers scene = [] then []
  else Reason.materials Material.emits scene

type estimate = Tally.t -> Path.t -> Receiver.t -> Rgb.t

let veiled veil : Path.t -> Point.t -> Point.t -> Rgb.t -> Rgb.t =
  match veil with
  | None -> fun _ _ _ light -> light
  | Some (veil : Direct.veil) ->
      fun path point at light -> Rgb.mul (veil path point (At at)) light

let is_light lights index (hit : Tracer.hit) =
  Area_lights.is_at lights index hit.path

let show lights tally index hit =
  let of_emitter (e : Emitters.t) =
    let seen = Option.fold hit ~none:false ~some:(is_light lights index) in
    Tally.show tally (Toward_emitter { emitter = e.place; seen })
  in
  Option.iter of_emitter (List.nth_opt (Area_lights.emitters lights) index)

let estimate ?veil lights (tracer : Tracer.t) : estimate =
  let veiled = veiled veil and chooses = Area_lights.chooses lights in
  fun tally path (r : Receiver.t) ->
    let choice = if chooses then Path.one path Emitter else 0. in
    let place = Path.pair path Emitter_direction in
    match Area_lights.sample lights r.vantage ~choice place with
    | None -> Rgb.black
    | Some { index; direction; density } -> (
        let response = r.respond direction in
        if Rgb.is_black response then Rgb.black
        else
          let ray = r.spawn (direction :> Vec.t) in
          Tally.count tally Emitter_rays;
          let hit = tracer.nearest tally path ray in
          if Tally.watched tally then show lights tally index hit;
          match hit with
          | Some hit when is_light lights index hit ->
              let light =
                veiled path r.vantage.from hit.point (Emission.radiance hit)
              and share = Receiver.power density (r.density direction) in
              Rgb.scale (share /. density) (Rgb.mul response light)
          | Some _ | None -> Rgb.black)

let weigh lights (path : Path.t) (hit : Tracer.hit) =
  match path.journey.arrival with
  | Sharp -> 1.
  | Spread { density; from } -> (
      match Area_lights.index lights hit.path with
      | None -> 1.
      | Some index -> (
          match Dir.of_vec (Point.sub hit.point from.from) with
          | None -> 1.
          | Some toward ->
              Receiver.power density
                (Area_lights.density lights from ~index toward)))

let term = Receiver.lit

open Candor_space
open Candor_colour
open Candor_sample
open Candor_scene
open Candor_optics

let name = "fog"
let meaning = "a medium takes light away and scatters it"

let calls (scene : Scene.t) =
  match scene.fog with
  | Some { value; place } when not (Rgb.is_black value.extinction) ->
      [ Reason.v "fog" place ]
  | Some _ | None -> []

type scatter = Tally.t -> Path.t -> Receiver.t -> Rgb.t
type order = Once | Again of Limit.t

let clear : Scene.fog =
  { extinction = Rgb.black; albedo = Rgb.black; anisotropy = 0.; within = None }

(* {1 Where it is} *)

type span = { from : float; until : float }

let crossing o d low high =
  if d = 0. then
    if low <= o && o <= high then { from = 0.; until = infinity }
    else { from = infinity; until = 0. }
  else
    let a = (low -. o) /. d and b = (high -. o) /. d in
    { from = Float.min a b; until = Float.max a b }

let both a b =
  { from = Float.max a.from b.from; until = Float.min a.until b.until }

(* The part of a way of this length that is in the fog. *)
let span (fog : Scene.fog) (o : Point.t) (d : Dir.t) length =
  let whole = { from = 0.; until = length } in
  match fog.within with
  | None -> whole
  | Some b ->
      let d = (d :> Vec.t) in
      let x = crossing o.x d.x b.x0 b.x1
      and y = crossing o.y d.y b.y0 b.y1
      and z = crossing o.z d.z b.z0 b.z1 in
      both whole (both x (both y z))

(* {1 On the way} *)

let deflected (path : Path.t) (medium : Medium.t) point (along : Dir.t) =
  let toward = Medium.deflect medium along (Path.pair path Deflection) in
  let density = Medium.phase medium along toward in
  (toward, Path.Spread { density; from = Receiver.in_space path point })

(* Whether a path that is scattered may meet lights by itself. *)
let goes_on (limit : Limit.t) (path : Path.t) =
  match limit with
  | Fixed { depth; _ } | Roulette { depth } -> path.depth < depth
  | At_once -> false

let again limit radiance tally (path : Path.t) medium point along =
  let survival =
    Limit.survival limit tally path Key.Deflection ~weight:Rgb.white
      ~beside:Rgb.black
  in
  if survival = 0. then Rgb.black
  else (
    Tally.count tally Scattered_rays;
    let toward, arrival = deflected path medium point along in
    let next =
      Path.onward path Key.Deflection
        (Rgb.scale survival path.throughput)
        { path.journey with arrival }
    in
    let ray = Ray.v point (toward :> Vec.t) in
    Rgb.scale survival (radiance tally ~kind:name next ray))

let segment (fog : Scene.fog) order (scatter : scatter) : Segment.t =
  let medium = Medium.of_fog fog in
  let at_point radiance tally (path : Path.t) weight (o : Point.t) along s =
    let point = Point.along o (along : Dir.t :> Vec.t) s in
    let path = { path with throughput = Rgb.mul path.throughput weight } in
    let receive goes_on =
      scatter tally path (Receiver.in_medium medium ~goes_on path point ~along)
    in
    let found =
      match order with
      | Once -> receive false
      | Again limit ->
          Rgb.add
            (receive (goes_on limit path))
            (again limit radiance tally path medium point along)
    in
    Rgb.mul weight found
  in
  let once radiance tally (path : Path.t) (ray : Ray.t) along { from; until }
      hit arrive =
    let limit = until -. from in
    let share = Medium.transmittance medium limit in
    let beyond = Segment.weighted share path ray hit arrive in
    match
      Medium.sample_within medium ~carried:path.throughput ~limit
        (Path.one path Distance)
    with
    | None -> beyond
    | Some (s, weight) ->
        Rgb.add beyond
          (at_point radiance tally path weight ray.origin along (from +. s))
  in
  let one_of radiance tally (path : Path.t) (ray : Ray.t) along { from; until }
      hit arrive =
    let limit = until -. from in
    match
      Medium.sample medium ~carried:path.throughput ~limit
        (Path.one path Distance)
    with
    | Passed { weight } -> Segment.weighted weight path ray hit arrive
    | Scattered { distance; weight } ->
        at_point radiance tally path weight ray.origin along (from +. distance)
  in
  let weaken _ _ path ray _ { from; until } hit arrive =
    let share = Medium.transmittance medium (until -. from) in
    Segment.weighted share path ray hit arrive
  in
  let through =
    match order with
    | (Once | Again _) when Rgb.is_black medium.scattering -> weaken
    | Once -> once
    | Again _ -> one_of
  in
  fun radiance tally path ray hit arrive ->
    match (path.journey.inside, Dir.of_vec ray.direction) with
    | _ :: _, _ | _, None -> arrive path ray hit
    | [], Some along ->
        let span = span fog ray.origin along (Segment.length ray hit) in
        if span.from < span.until then
          through radiance tally path ray along span hit arrive
        else arrive path ray hit

let veil (fog : Scene.fog) : Direct.veil =
  let medium = Medium.of_fog fog in
  fun path point source ->
    match path.journey.inside with
    | _ :: _ -> Rgb.white
    | [] ->
        let toward =
          match source with
          | At light -> Point.sub light point
          | Along toward -> toward
        in
        let along = Dir.of_vec_or Dir.z toward in
        let { from; until } =
          span fog point along (Segment.distance point source)
        in
        Medium.transmittance medium (Float.max 0. (until -. from))

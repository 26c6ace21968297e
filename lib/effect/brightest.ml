open Candor_colour
open Candor_scene
open Candor_optics

type t = At_most of Rgb.t | Unbounded of string [@@deriving show, eq]

(* A point of radiance L or less wherever it looks has itself at most
   adds + passes·L. *)
type part = { adds : Rgb.t; passes : Rgb.t }

let ( let* ) = Result.bind

(* [part] of some light, which need not be bounded where nothing shows it. *)
let times part light =
  if Rgb.is_black part then Ok Rgb.black
  else Result.map (Rgb.mul part) (Lazy.force light)

let sum lights =
  List.fold_left
    (fun sum light ->
      let* sum = sum in
      Result.map (Rgb.add sum) light)
    (Ok Rgb.black) lights

(* {1 Lights} *)

let lamp near (l : Light.t) =
  match l.kind with
  | Directional { irradiance; _ } -> Ok irradiance
  | Point { intensity; falloff = Constant; _ }
  | Spot { intensity; falloff = Constant; _ } ->
      Ok intensity
  | Point { at; intensity; falloff = Square }
  | Spot { at; intensity; falloff = Square; _ } ->
      let distance = Lazy.force near at in
      let most = Rgb.scale (1. /. distance /. distance) intensity in
      if distance > 0. && Rgb.is_finite most then Ok most
      else
        Error
          (Printf.sprintf
             "the %s [%s] may shine from no distance, without bound"
             (Direct.describe l) (Place.to_string l.place))

(* Irradiance by all lamps, of which no point is nearer than [near] says. *)
let lamps near (scene : Scene.t) =
  lazy (sum (List.map (lamp near) (List.filter Direct.shines scene.lights)))

let emission uses =
  List.fold_left
    (fun most (u : Assembly.use) -> Rgb.greater most u.material.emission)
    Rgb.black uses

let background (scene : Scene.t) =
  match scene.background with
  | Uniform c -> c
  | Gradient { down; up } -> Rgb.greater down up
  | Image { texels; _ } -> Texels.greatest texels

(* {1 Surfaces} *)

type light = {
  bounces : bool;  (** whether light that bounces is followed *)
  ambient : Rgb.t;
  lamps : (Rgb.t, string) result Lazy.t;
  areas : Rgb.t;
      (** of what surfaces are lit by besides, the greatest radiance *)
  inside : (unit, string) result Lazy.t;
      (** whether no lamp lights translucent bodies from within *)
}

let if_not bounces c = if bounces then Rgb.black else c
let if_bounced bounces c = if bounces then c else Rgb.black

(* Under indirect light area lights are among what is passed on. *)
let matte light colour =
  let* lamps = times colour light.lamps in
  let steady = Rgb.add light.ambient (if_not light.bounces light.areas) in
  Ok
    {
      adds = Rgb.add (Rgb.mul colour steady) (Rgb.scale (1. /. Float.pi) lamps);
      passes = if_bounced light.bounces colour;
    }

(* The integral of (n·h)^N over directions to light is at most that of
   4·(n·h)^N over h: 8π / (N + 1); nor is it above the whole hemisphere. *)
let highlight light specular shininess =
  let share =
    Float.min (2. *. Float.pi) (8. *. Float.pi /. (shininess +. 1.))
  in
  let areas = Rgb.scale share light.areas in
  times specular (lazy (Result.map (Rgb.add areas) (Lazy.force light.lamps)))

(* A microfacet BRDF times the cosine: D ≤ 1/πα², and the rest is at most 1/2α. *)
let peak alpha = Rgb.grey (0.5 /. (Float.pi *. alpha *. alpha *. alpha))

let glossy light value =
  let* lamps = times value light.lamps in
  Ok
    {
      adds = Rgb.add lamps (if_not light.bounces light.areas);
      passes = if_bounced light.bounces Rgb.white;
    }

let passing = { adds = Rgb.black; passes = Rgb.white }

(* What a smooth coat does not reflect lights the base, and the mean of both is
   no brighter than either. *)
let plastic light ~color ~index ~roughness =
  let coat = Coat.make ~index ~roughness in
  let base = Coat.base coat color in
  if roughness > 0. then
    let* part = glossy light (Rgb.add (peak (Coat.alpha coat)) base) in
    Ok [ part ]
  else
    let* part =
      matte { light with ambient = Rgb.black } (Rgb.scale Float.pi base)
    in
    let passes = if_bounced light.bounces Rgb.white in
    Ok [ { part with passes }; passing ]

let parts light (m : Material.t) =
  let one part = Result.map (fun part -> [ part ]) part in
  match m.kind with
  | Matte { color } -> one (matte light (Texture.greatest color))
  | Phong { color; specular; shininess } ->
      let* part = matte light (Texture.greatest color) in
      let* shine = highlight light specular shininess in
      Ok [ { part with adds = Rgb.add part.adds shine } ]
  | Mirror { color } -> Ok [ { passing with passes = Texture.greatest color } ]
  | Glazed { color; mirror } ->
      let* part = matte light (Texture.greatest color) in
      Ok [ { part with passes = Rgb.add part.passes mirror } ]
  | Glass _ -> Ok [ passing ]
  | Translucent _ ->
      Result.map (fun () -> [ passing ]) (Lazy.force light.inside)
  | Metal { roughness; _ } ->
      if roughness > 0. then
        one (glossy light (peak (Float.max roughness 0x1p-32)))
      else Ok [ passing ]
  | Plastic { color; index; roughness } ->
      plastic light ~color:(Texture.greatest color) ~index ~roughness
  | Emitter -> Ok [ { adds = Rgb.black; passes = Rgb.black } ]

(* {1 Bounds} *)

let settled adds passes =
  if adds = 0. then 0.
  else if passes < 1. then adds /. (1. -. passes)
  else infinity

let brightness { adds; passes } =
  Rgb.v (settled adds.r passes.r) (settled adds.g passes.g)
    (settled adds.b passes.b)

let brightest (reason : Reason.t) parts =
  let most =
    List.fold_left
      (fun most part -> Rgb.greater most (brightness part))
      Rgb.black parts
  in
  if Rgb.is_finite most then Ok most
  else
    Error
      (Printf.sprintf "%s [%s] adds light and passes on all that it gets"
         reason.what
         (Place.to_string reason.place))

let of_use light (u : Assembly.use) =
  let* parts = parts light u.material in
  let emitting part =
    { part with adds = Rgb.add u.material.emission part.adds }
  in
  brightest (Reason.of_use u) (List.map emitting parts)

(* {1 Fog} *)

(* The greatest value of Henyey and Greenstein's phase function: straight on, or
   straight back. *)
let phase g =
  let g = Float.abs g in
  (1. +. g) /. (4. *. Float.pi *. (1. -. g) *. (1. -. g))

(* What fog takes away it replaces by what it scatters, its albedo times a mean
   of what it gets: no light is added but that of lamps. *)
let of_fog light scene ({ value; place } : Scene.fog Scene.placed) =
  let { Scene.extinction; albedo; anisotropy; within } = value in
  if Rgb.is_black (Rgb.mul extinction albedo) then Ok Rgb.black
  else
    let near p =
      match within with None -> 0. | Some b -> Nearness.to_bounds b p
    in
    let share = Rgb.scale (phase anisotropy) albedo in
    let* lamps = times share (lamps (lazy near) scene) in
    let areas = Rgb.mul albedo (if_not light.bounces light.areas) in
    let passes = if_bounced light.bounces albedo in
    brightest (Reason.v "fog" place) [ { adds = Rgb.add lamps areas; passes } ]

(* {1 The whole} *)

let lit_from_within (scene : Scene.t) =
  let moving = Motion_blur.calls scene <> [] in
  let tracer = lazy (Tracer.still (Skin.surface scene)) in
  let reaches (l : Light.t) =
    match l.kind with
    | Directional _ -> false
    | Point _ | Spot _ ->
        Direct.shines l && Subsurface.may_reach ~moving (Lazy.force tracer) l
  in
  lazy
    (match List.find_opt reaches scene.lights with
    | None -> Ok ()
    | Some l ->
        Error
          (Printf.sprintf "the %s [%s] may shine inside translucent bodies"
             (Direct.describe l) (Place.to_string l.place)))

let light (scene : Scene.t) uses =
  let bounces = Option.is_some scene.indirect in
  {
    bounces;
    ambient =
      (match scene.ambient with
      | Some { value; _ } -> value
      | None -> Rgb.black);
    lamps = lamps (lazy (Nearness.to_surfaces scene)) scene;
    areas =
      (if bounces then Rgb.greater (emission uses) (background scene)
       else emission uses);
    inside = lit_from_within scene;
  }

(* Light that takes a wavelength is coloured so that the mean of all is white,
   taken over 256 steps: the sum of curves that rise and fall once is right
   within an eighth. *)
let dispersed scene most =
  if Dispersion.calls scene = [] then most else Rgb.scale 1.125 most

let greatest results =
  List.fold_left
    (fun most found ->
      let* most = most in
      Result.map (Rgb.greater most) found)
    (Ok Rgb.black) results

let of_scene (scene : Scene.t) =
  let uses = Assembly.materials_in_use scene in
  let light = light scene uses in
  let fog = Option.map (of_fog light scene) scene.fog in
  let found =
    greatest
      ((Ok (background scene) :: Option.to_list fog)
      @ List.map (of_use light) uses)
  in
  match found with
  | Ok most when Rgb.is_finite most -> At_most (dispersed scene most)
  | Ok _ -> Unbounded "the background is infinitely bright"
  | Error why -> Unbounded why

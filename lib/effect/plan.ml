open Candor_colour
open Candor_scene

type status = Called of Reason.t list | Forced | Off
[@@deriving show, eq, ord]

type bound =
  | Steps of { most : int; why : string }
  | Unbounded of { why : string }
[@@deriving show, eq]

type t = {
  effects : (Effect.t * status) list;
  depth : bound;
  forced : bool;
  bounces : bool;  (** whether light that bounces is followed *)
}
[@@deriving show, eq]

let status_in effects e = Option.value (List.assoc_opt e effects) ~default:Off

let called_in effects e =
  match status_in effects e with Called _ -> true | Forced | Off -> false

let steps : Effect.t list = [ Mirror; Refraction; Indirect ]

let bound effects (scene : Scene.t) =
  match List.filter (called_in effects) steps with
  | [] -> Steps { most = 0; why = "nothing reflects" }
  | called -> (
      let limit = Scene.depth scene in
      let once =
        match called with
        | [ Mirror ] when not (called_in effects Fog) -> Single_mirror.why scene
        | [] | _ :: _ -> None
      in
      match once with
      | Some why when limit >= 1 -> Steps { most = 1; why }
      | Some _ | None ->
          if limit < max_int then
            Steps { most = limit; why = "the scene's limit" }
          else
            Unbounded { why = "under indirect light paths end by chance alone" }
      )

let make ?omitted scene ~forced extra =
  let otherwise e =
    if List.exists (Effect.equal e) extra then Forced else Off
  in
  let status e =
    match Effect.calls e scene with
    | _ when Option.equal Effect.equal omitted (Some e) -> Off
    | [] -> otherwise e
    | _ :: _ as reasons -> Called reasons
  in
  let effects = List.map (fun e -> (e, status e)) Effect.all in
  let bounces = Option.is_some scene.Scene.indirect in
  { effects; depth = bound effects scene; forced; bounces }

let of_scene scene = make scene ~forced:false []
let forcing effects scene = make scene ~forced:false effects
let all scene = make scene ~forced:true Effect.all
let without e scene = make ~omitted:e scene ~forced:false []
let is_forced plan = plan.forced
let status plan = status_in plan.effects

let is_on plan e =
  match status plan e with Called _ | Forced -> true | Off -> false

let is_called plan = called_in plan.effects
let depth plan = plan.depth

let random : Effect.t -> bool = function
  | Soft_shadows | Sky_light | Refraction | Dispersion | Subsurface | Gloss
  | Indirect | Fog | Depth_of_field | Motion_blur ->
      true
  | Emission | Ambient | Direct | Shadows | Mirror | Absorption | Textures
  | Smooth_normals | Anti_aliasing ->
      false

(* Under indirect light mirrors end by chance, too. *)
let is_random plan =
  List.exists (fun e -> random e && is_on plan e) Effect.all
  || (plan.bounces && is_on plan Mirror)

let cut_at_once plan scene =
  if Scene.depth scene > 0 then []
  else List.filter (called_in plan.effects) steps

(* {1 Assembling} *)

type equation = {
  terms : (Effect.t * Term.t) list;
  segment : Segment.t option;
  sky : Path.t -> Candor_space.Vec.t -> Rgb.t;
  tracer : Tracer.t;
}

(* What several terms have in common. *)
type parts = {
  plan : t;
  scene : Scene.t;
  tracer : Tracer.t;
  bounces : bool;  (** whether light that bounces is followed *)
  limit : Limit.t;
  scattering : Candor_optics.Scattering.t;
  veil : Direct.veil option;
  lamps : Direct.lamp list;
  emitters : Candor_optics.Area_lights.t Lazy.t;
  sky : Candor_optics.Sampled_sky.t option;
}

let fog (scene : Scene.t) =
  match scene.fog with Some { value; _ } -> value | None -> Fog.clear

let veil plan scene : Direct.veil option =
  let inside = is_on plan Absorption || is_on plan Subsurface
  and outside = is_on plan Fog in
  let fog = Fog.veil (fog scene) in
  match (inside, outside) with
  | false, false -> None
  | true, false -> Some Absorption.veil
  | false, true -> Some fog
  | true, true ->
      Some
        (fun path point source ->
          match path.journey.inside with
          | [] -> fog path point source
          | _ :: _ -> Absorption.veil path point source)

let lamp plan tracer (light : Light.t) : Direct.lamp =
  let casts = is_on plan Shadows && light.shadows in
  {
    light;
    reach = (if casts then Shadows.reach tracer light else Direct.always);
  }

let limit (scene : Scene.t) : Limit.t =
  let depth = Scene.depth scene in
  if Option.is_some scene.indirect then Roulette { depth }
  else Fixed { depth; cutoff = scene.settings.cutoff }

let parts plan (scene : Scene.t) surface =
  let tracer =
    if is_on plan Motion_blur then Tracer.moving surface
    else Tracer.still surface
  and bounces = Option.is_some scene.indirect in
  {
    plan;
    scene;
    tracer;
    bounces;
    limit = limit scene;
    scattering =
      (if is_on plan Gloss then Candor_optics.Scattering.glossy
       else Candor_optics.Scattering.matte);
    veil = veil plan scene;
    lamps =
      List.filter (fun l -> plan.forced || Direct.shines l) scene.lights
      |> List.map (lamp plan tracer);
    emitters = lazy (Candor_optics.Area_lights.make scene);
    sky =
      (if is_on plan Sky_light && bounces then Sky_light.sky scene else None);
  }

(* What of it depends on the scene alone is asked once. *)
let goes_on p =
  if not p.bounces then fun (vertex : Term.vertex) ->
    Option.is_some vertex.lobes.gloss
  else
    let follows = is_on p.plan Indirect and depth = Scene.depth p.scene in
    fun vertex -> follows && vertex.path.depth < depth

let soft_shadows p =
  Soft_shadows.estimate ?veil:p.veil (Lazy.force p.emitters) p.tracer

let sky_light p sky = Sky_light.estimate ?veil:p.veil sky p.tracer

(* First hits of glass are worth both ways even where one of them would do. *)
let splits p = if p.bounces then 1 else max_int

let refraction p =
  let refraction index =
    Refraction.term index ~splits:(splits p) p.limit p.tracer
  in
  if is_on p.plan Dispersion then Dispersion.term refraction
  else refraction Refraction.index

let ambient (scene : Scene.t) =
  match scene.ambient with Some { value; _ } -> value | None -> Rgb.black

let emission p =
  if is_on p.plan Soft_shadows && p.bounces then
    Emission.term ~weigh:(Soft_shadows.weigh (Lazy.force p.emitters)) ()
  else Emission.term ()

let term p : Effect.t -> Term.t option = function
  | Emission -> Some (emission p)
  | Ambient -> Some (Ambient.term (ambient p.scene))
  | Direct ->
      let shading =
        if is_on p.plan Gloss then Direct.glossy else Direct.matte
      in
      Some (Direct.term shading ?veil:p.veil p.lamps)
  | Soft_shadows ->
      Some
        (Soft_shadows.term p.scattering ~goes_on:(goes_on p) (soft_shadows p))
  | Sky_light ->
      let term sky =
        Sky_light.term p.scattering ~goes_on:(goes_on p) (sky_light p sky)
      in
      Option.map term p.sky
  | Mirror -> Some (Mirror.term p.limit)
  | Refraction -> Some (refraction p)
  | Gloss ->
      if p.bounces || not (is_on p.plan Soft_shadows) then None
      else Some (Glossy.term ?veil:p.veil (Lazy.force p.emitters) p.tracer)
  | Indirect ->
      let limit = if p.bounces then p.limit else Limit.At_once in
      Some (Indirect.term p.scattering limit)
  | Shadows | Dispersion | Absorption | Subsurface | Fog | Depth_of_field
  | Motion_blur | Textures | Smooth_normals | Anti_aliasing ->
      None

(* The light of all lights that a point of a medium scatters. *)
let scatter p : Fog.scatter =
  let on e f = if is_on p.plan e then Some (f ()) else None in
  let found =
    List.filter_map Fun.id
      [
        on Direct (fun () -> Direct.scattered ?veil:p.veil p.lamps);
        on Soft_shadows (fun () -> soft_shadows p);
        Option.map (sky_light p) p.sky;
      ]
  in
  fun tally path receiver ->
    List.fold_left
      (fun sum light -> Rgb.add sum (light tally path receiver))
      Rgb.black found

let scatter_in_bodies p : Subsurface.scatter =
  let moving = Motion_blur.calls p.scene <> [] in
  let reaches (lamp : Direct.lamp) =
    Subsurface.may_reach ~moving p.tracer lamp.light
  in
  let lamps = if is_on p.plan Direct then p.lamps else [] in
  Direct.scattered ?veil:p.veil (List.filter reaches lamps)

let segment p : Effect.t -> Segment.t option = function
  | Absorption -> Some Absorption.segment
  | Subsurface -> Some (Subsurface.segment p.tracer (scatter_in_bodies p))
  | Fog ->
      let order : Fog.order = if p.bounces then Again p.limit else Once in
      Some (Fog.segment (fog p.scene) order (scatter p))
  | Emission | Ambient | Direct | Shadows | Soft_shadows | Sky_light | Mirror
  | Refraction | Dispersion | Gloss | Indirect | Depth_of_field | Motion_blur
  | Textures | Smooth_normals | Anti_aliasing ->
      None

let compile plan scene surface =
  let p = parts plan scene surface in
  let on = List.filter (is_on plan) Effect.all in
  let segments = List.filter_map (segment p) on in
  {
    terms =
      List.filter_map (fun e -> Option.map (fun t -> (e, t)) (term p e)) on;
    segment =
      (match segments with
      | [] -> None
      | first :: rest -> Some (List.fold_left Segment.after first rest));
    sky = Sky_light.radiance scene p.sky;
    tracer = p.tracer;
  }

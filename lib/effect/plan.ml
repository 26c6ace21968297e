open Candor_colour
open Candor_scene

type status = Called of Reason.t list | Forced | Off
[@@deriving show, eq, ord]

type t = { effects : (Effect.t * status) list; limit : int }
[@@deriving show, eq]

let make (scene : Scene.t) otherwise =
  let status e =
    match Effect.calls e scene with
    | [] -> otherwise
    | _ :: _ as reasons -> Called reasons
  in
  {
    effects = List.map (fun e -> (e, status e)) Effect.all;
    limit = scene.settings.depth;
  }

let of_scene scene = make scene Off
let all scene = make scene Forced
let status plan e = Option.value (List.assoc_opt e plan.effects) ~default:Off

let is_on plan e =
  match status plan e with Called _ | Forced -> true | Off -> false

let depth plan =
  match status plan Mirror with Called _ -> plan.limit | Forced | Off -> 0

type terms = (Effect.t * Term.t) list

let ambient (scene : Scene.t) =
  match scene.ambient with Some { value; _ } -> value | None -> Rgb.black

let reach plan surface (light : Light.t) =
  if is_on plan Shadows && light.shadows then Shadows.reach surface light
  else Direct.always

let term plan (scene : Scene.t) surface : Effect.t -> Term.t option = function
  | Ambient -> Some (Ambient.term (ambient scene))
  | Direct ->
      let lit l = (l, reach plan surface l) in
      Some (Direct.term (List.map lit scene.lights))
  | Shadows -> None
  | Mirror ->
      let { Scene.depth; cutoff; _ } = scene.settings in
      Some (Mirror.term ~depth ~cutoff)

let compile plan scene surface =
  List.filter (is_on plan) Effect.all
  |> List.filter_map (fun e ->
      Option.map (fun t -> (e, t)) (term plan scene surface e))

open Candor_space
open Candor_sample
open Candor_colour

type t =
  | Metal of { reflectance : Rgb.t; alpha : float }
  | Plastic of { coat : Coat.t; base : Rgb.t; albedo : float }

let metal ~reflectance ~roughness =
  let alpha = if roughness > 0. then Float.max roughness 0x1p-32 else 0. in
  Metal { reflectance; alpha }

let plastic coat ~color =
  let albedo = Rgb.largest (Coat.albedo coat color) in
  Plastic { coat; base = Coat.base coat color; albedo }

let alpha = function
  | Metal { alpha; _ } -> alpha
  | Plastic { coat; _ } -> Coat.alpha coat

let is_smooth t = alpha t = 0.

let schlick (f : Rgb.t) cos =
  let x = if cos < 1. then 1. -. cos else 0. in
  let x5 = x *. x *. x *. x *. x in
  Rgb.v
    (f.r +. ((1. -. f.r) *. x5))
    (f.g +. ((1. -. f.g) *. x5))
    (f.b +. ((1. -. f.b) *. x5))

let specular t ~cos =
  match t with
  | Metal { reflectance; _ } -> schlick reflectance cos
  | Plastic { coat; _ } -> Rgb.grey (Coat.reflectance coat cos)

let[@inline] cosine (a : Dir.t) (b : Dir.t) = Vec.dot (a :> Vec.t) (b :> Vec.t)

(* To the normal between two unit directions: half the length of their sum. *)
let[@inline] halfway (a : Dir.t) (b : Dir.t) =
  let h = Vec.add (a :> Vec.t) (b :> Vec.t) in
  0.5 *. sqrt (Vec.dot h h)

let[@inline] glossy alpha ~normal ~view ~toward =
  if alpha = 0. then 0. else Microfacet.reflection ~alpha ~normal ~view ~toward

let value t ~normal ~view ~toward =
  let c = cosine normal view and c' = cosine normal toward in
  if not (c > 0. && c' > 0.) then Rgb.black
  else
    match t with
    | Metal { reflectance; alpha } ->
        let mirrors = glossy alpha ~normal ~view ~toward in
        Rgb.scale (c' *. mirrors) (schlick reflectance (halfway view toward))
    | Plastic { coat; base; albedo = _ } ->
        let through = Coat.transmittance coat c *. Coat.transmittance coat c' in
        let alpha = Coat.alpha coat in
        let off =
          if alpha = 0. then 0.
          else
            Coat.reflectance coat (halfway view toward)
            *. glossy alpha ~normal ~view ~toward
        in
        Rgb.v
          (c' *. (off +. (through *. base.r)))
          (c' *. (off +. (through *. base.g)))
          (c' *. (off +. (through *. base.b)))

(* The chance of sampling the coat: its part of the light seen at cosine [c]. *)
let coat_chance coat albedo c =
  if Coat.alpha coat = 0. then 0.
  else
    let inside = Coat.transmittance coat c in
    let off = 1. -. inside in
    if off > 0. then off /. (off +. (inside *. albedo)) else 0.

let density t ~normal ~view ~toward =
  let c = cosine normal view and c' = cosine normal toward in
  if not (c > 0. && c' > 0.) then 0.
  else
    match t with
    | Metal { alpha; _ } ->
        if alpha = 0. then 0.
        else Microfacet.density ~alpha ~normal ~view ~toward
    | Plastic { coat; albedo; base = _ } ->
        let alpha = Coat.alpha coat and chance = coat_chance coat albedo c in
        let off =
          if chance > 0. then
            chance *. Microfacet.density ~alpha ~normal ~view ~toward
          else 0.
        in
        off +. ((1. -. chance) *. c' /. Float.pi)

type sample = { toward : Dir.t; weight : Rgb.t; density : float }

(* {1 Directions, the normal being the z axis} *)

let mirrored alpha view ~u ~v =
  let half = Microfacet.seen ~alpha view ~u ~v in
  Vec.sub (Vec.scale (2. *. Vec.dot view half) half) view

let draw t view ~choice ~u ~v =
  match t with
  | Metal { alpha; _ } ->
      if alpha = 0. then None else Some (mirrored alpha view ~u ~v)
  | Plastic { coat; albedo; base = _ } ->
      if choice < coat_chance coat albedo view.Vec.z then
        Some (mirrored (Coat.alpha coat) view ~u ~v)
      else Some (Warp.cosine_hemisphere { u; v } :> Vec.t)

let weighed t ~normal ~view toward =
  let density = density t ~normal ~view ~toward in
  if density > 0. then
    let weight = Rgb.scale (1. /. density) (value t ~normal ~view ~toward) in
    Some { toward; weight; density }
  else None

let sample t ~normal ~view ~choice ~u ~v =
  if not (cosine normal view > 0.) then None
  else
    let frame = Frame.of_dir normal in
    let weighed local = weighed t ~normal ~view (Warp.to_world frame local) in
    Option.bind (draw t (Warp.to_local frame view) ~choice ~u ~v) weighed

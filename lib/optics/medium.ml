open Candor_space
open Candor_colour
open Candor_sample
open Candor_scene

type t = { extinction : Rgb.t; scattering : Rgb.t; anisotropy : float }

let of_fog (f : Scene.fog) =
  {
    extinction = f.extinction;
    scattering = Rgb.mul f.albedo f.extinction;
    anisotropy = f.anisotropy;
  }

let of_material (m : Material.t) =
  match m.kind with
  | Glass { absorption; _ } when not (Rgb.is_black absorption) ->
      Some { extinction = absorption; scattering = Rgb.black; anisotropy = 0. }
  | Translucent { scattering; absorption; anisotropy; _ } ->
      let extinction = Rgb.add scattering absorption in
      Some { extinction; scattering; anisotropy }
  | Glass _ | Matte _ | Phong _ | Mirror _ | Glazed _ | Metal _ | Plastic _
  | Emitter ->
      None

let[@inline] through rate s = if rate = 0. then 1. else exp (-.rate *. s)

let transmittance m s =
  let { Rgb.r; g; b } = m.extinction in
  Rgb.v (through r s) (through g s) (through b s)

type event =
  | Scattered of { distance : float; weight : Rgb.t }
  | Passed of { weight : Rgb.t }

let below_one = Float.pred 1.
let sum (c : Rgb.t) = c.r +. c.g +. c.b

(* How often each colour is asked: as much as the path still carries of it. *)
let shares carried =
  let all = sum carried in
  if all > 0. then Rgb.scale (1. /. all) carried else Rgb.grey (1. /. 3.)

(* The component of [c] for one of the colours, and what is left of a uniform
   number. *)
let colour { Rgb.r; g; b } (c : Rgb.t) u =
  if u < r then (c.r, u /. r)
  else if u < r +. g then (c.g, (u -. r) /. g)
  else if b > 0. then (c.b, Float.min below_one ((u -. r -. g) /. b))
  else if g > 0. then (c.g, below_one)
  else (c.r, below_one)

let sample m ~carried ~limit u =
  let shares = shares carried in
  let rate, u = colour shares m.extinction u in
  let distance = if rate = 0. then infinity else Warp.exponential ~rate u in
  if distance < limit then
    let t = transmittance m distance in
    let density = sum (Rgb.mul shares (Rgb.mul m.extinction t)) in
    let weight = Rgb.scale (1. /. density) (Rgb.mul m.scattering t) in
    Scattered { distance; weight }
  else
    let t = transmittance m limit in
    let chance = sum (Rgb.mul shares t) in
    Passed { weight = (if chance > 0. then Rgb.scale (1. /. chance) t else t) }

(* The density of a distance up to the limit by one colour. *)
let[@inline] density_within rate s limit =
  if rate = 0. then 0.
  else rate *. exp (-.rate *. s) /. -.Float.expm1 (-.rate *. limit)

let sample_within m ~carried ~limit u =
  let e = m.extinction and shares = shares carried in
  let rate, u = colour shares e u in
  if Rgb.is_black m.scattering || not (limit > 0.) then None
  else if rate = 0. then Some (0., Rgb.black)
  else
    let share = -.Float.expm1 (-.rate *. limit) in
    let s = Warp.exponential ~rate (u *. share) in
    let density =
      (shares.r *. density_within e.r s limit)
      +. (shares.g *. density_within e.g s limit)
      +. (shares.b *. density_within e.b s limit)
    in
    let weight = Rgb.mul m.scattering (transmittance m s) in
    Some (s, Rgb.scale (1. /. density) weight)

(* {1 Scattering} *)

let phase m along d = Warp.henyey_greenstein ~g:m.anisotropy along d

let deflect m along p =
  let local = Warp.henyey_greenstein_sample ~g:m.anisotropy p in
  Warp.to_world (Frame.of_dir along) (local :> Vec.t)

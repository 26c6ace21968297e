open Candor_space
open Candor_colour
open Candor_scene
open Candor_surface
open Candor_optics
module Boundary = Candor_optics.Refraction

let name = "refraction"
let meaning = "glass reflects a part of the light and bends the rest"

(* What a boundary multiplies light by, if it lets any through. *)
let colour (m : Material.t) : Texture.t option =
  match m.kind with
  | Glass { color; _ } -> Some color
  | Translucent _ -> Some (Constant Rgb.white)
  | Matte _ | Phong _ | Mirror _ | Glazed _ | Metal _ | Plastic _ | Emitter ->
      None

let is_body m = Option.is_some (colour m)
let calls = Reason.materials is_body

type index = Path.t -> Material.t -> float

let index _ (m : Material.t) =
  match m.kind with
  | Glass { index; _ } | Translucent { index; _ } -> index
  | Matte _ | Phong _ | Mirror _ | Glazed _ | Metal _ | Plastic _ | Emitter ->
      1.

(* {1 Media} *)

let rec without m = function
  | [] -> []
  | top :: rest -> if top == m then rest else top :: without m rest

(* The bodies around on the side that the ray comes from, and on the other. *)
let around (side : Side.t) m inside =
  match side with
  | Outside -> (inside, m :: inside)
  | Inside ->
      let beyond = without m inside in
      let here = if List.memq m inside then inside else m :: inside in
      (here, beyond)

let index_in index path = function [] -> 1. | top :: _ -> index path top

(* {1 Boundaries} *)

(* What a ray comes to: the media on both sides, what each way is multiplied by,
   and the rays that leave. *)
type boundary = {
  here : Material.t list;
  beyond : Material.t list;
  reflecting : Rgb.t;
  transmitting : Rgb.t;
  back : Vec.t -> Ray.t;
  onward : Vec.t -> Ray.t;
}

let alone (hit : Tracer.hit) colour inside =
  let here, beyond = around hit.side hit.material.material inside in
  {
    here;
    beyond;
    reflecting = colour;
    transmitting = colour;
    back = Hit.spawn hit;
    onward = Hit.spawn hit;
  }

let touching (tracer : Tracer.t) tally path { Hit.onto; limit; _ } =
  tracer.within tally path ~limit onto

(* Bodies that touch have one boundary between them. *)
let with_touching boundary place (hit : Tracer.hit) (other : Tracer.hit) colour
    =
  let m = other.material.material in
  let missed = other.side = Inside && not (List.memq m boundary.beyond) in
  let _, beyond = around other.side m boundary.beyond in
  {
    boundary with
    here = (if missed then m :: boundary.here else boundary.here);
    beyond;
    transmitting = Rgb.mul boundary.transmitting colour;
    back = Hit.spawn_clear hit place;
    onward = Hit.spawn_clear other place;
  }

(* {1 Both ways} *)

let follow limit radiance tally (path : Path.t) purpose ~weight inside ray =
  let survival =
    Limit.survival limit tally path purpose ~weight ~beside:Rgb.black
  in
  if survival = 0. then Rgb.black
  else (
    Tally.count tally Refraction_rays;
    let weight = Rgb.scale survival weight in
    let journey = { path.journey with arrival = Sharp; inside } in
    let next =
      Path.onward path purpose (Rgb.mul path.throughput weight) journey
    in
    Rgb.mul weight (radiance tally ~kind:name next ray))

(* An interpolated normal may bend light back to where it came from; what goes
   through stays behind the surface. *)
let through (hit : Tracer.hit) (d : Dir.t) ~straight =
  if Dir.dot hit.normal d < 0. then d else straight

let cross index ~splits limit radiance tally
    ({ hit; view; path; _ } : Term.vertex) along b =
  let indices =
    {
      Boundary.from = index_in index path b.here;
      into = index_in index path b.beyond;
    }
  in
  let reflected share =
    let weight = Rgb.scale share b.reflecting in
    follow limit radiance tally path Reflected ~weight b.here
      (b.back (Mirror.direction hit view))
  and transmitted direction share =
    let weight = Rgb.scale share b.transmitting in
    let d = through hit direction ~straight:along in
    follow limit radiance tally path Transmitted ~weight b.beyond
      (b.onward (d :> Vec.t))
  in
  match Boundary.at indices ~normal:hit.shading_normal along with
  | Total_reflection -> reflected 1.
  | Transmitted { direction; reflectance } ->
      if path.depth < splits then
        let back = reflected reflectance in
        Rgb.add back (transmitted direction (1. -. reflectance))
      else if Path.one path Boundary < reflectance then reflected 1.
      else transmitted direction 1.

let term index ~splits limit (tracer : Tracer.t) : Term.t =
 fun radiance tally ({ hit; view; path; _ } as vertex) ->
  match colour hit.material.material with
  | None -> Rgb.black
  | Some texture -> (
      let along = Dir.of_vec_or (Dir.neg hit.normal) (Vec.neg view) in
      let alone =
        alone hit (Colour_at.v texture hit.local) path.journey.inside
      in
      let cross = cross index ~splits limit radiance tally vertex along in
      let place = Hit.place hit (Vec.neg view) in
      match touching tracer tally path place with
      | None -> cross alone
      | Some other -> (
          match colour other.material.material with
          | Some texture ->
              cross
                (with_touching alone place hit other
                   (Colour_at.v texture other.local))
          | None ->
              (* What is opaque is met without leaving the body first. *)
              let journey = { path.journey with inside = alone.here } in
              radiance tally ~kind:name { path with journey } place.onto))

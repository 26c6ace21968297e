open Candor_colour
open Candor_scene

let name = "dispersion"
let meaning = "glass bends blue light more than red"

let disperses (m : Material.t) =
  match m.kind with
  | Glass { dispersion; _ } -> Option.is_some dispersion
  | Matte _ | Phong _ | Mirror _ | Glazed _ | Metal _ | Plastic _
  | Translucent _ | Emitter ->
      false

let calls = Reason.materials disperses

let index_at ~index ~abbe l =
  let inverse_square l = 1. /. (l *. l) in
  let f = inverse_square 486.1 and c = inverse_square 656.3 in
  let b = (index -. 1.) /. (abbe *. (f -. c)) in
  let n = index +. (b *. (inverse_square l -. inverse_square 587.6)) in
  Float.max 0x1p-10 n

(* {1 Colours} *)

let shortest = 380.
let longest = 720.
let wavelength u = shortest +. ((longest -. shortest) *. u)

(* A bell whose two halves differ in width. *)
let bell l ~height ~middle ~below ~above =
  let x = (l -. middle) /. if l < middle then below else above in
  height *. exp (-0.5 *. x *. x)

let raw l =
  let bell = bell l in
  let x =
    bell ~height:1.056 ~middle:599.8 ~below:37.9 ~above:31.
    +. bell ~height:0.362 ~middle:442. ~below:16. ~above:26.7
    +. bell ~height:(-0.065) ~middle:501.1 ~below:20.4 ~above:26.2
  and y =
    bell ~height:0.821 ~middle:568.8 ~below:46.9 ~above:40.5
    +. bell ~height:0.286 ~middle:530.9 ~below:16.3 ~above:31.1
  and z =
    bell ~height:1.217 ~middle:437. ~below:11.8 ~above:36.
    +. bell ~height:0.681 ~middle:459. ~below:26. ~above:13.8
  in
  let positive a = Float.max 0. a in
  Rgb.v
    (positive ((3.2406 *. x) -. (1.5372 *. y) -. (0.4986 *. z)))
    (positive ((-0.9689 *. x) +. (1.8758 *. y) +. (0.0415 *. z)))
    (positive ((0.0557 *. x) -. (0.204 *. y) +. (1.057 *. z)))

let steps = 256

let mean =
  let at i = raw (wavelength ((float_of_int i +. 0.5) /. float_of_int steps)) in
  let sum = List.fold_left Rgb.add Rgb.black (List.init steps at) in
  Rgb.scale (1. /. float_of_int steps) sum

let colour l =
  let { Rgb.r; g; b } = raw l in
  Rgb.v (r /. mean.r) (g /. mean.g) (b /. mean.b)

(* {1 Paths} *)

let index (path : Path.t) (m : Material.t) =
  match (m.kind, path.journey.wavelength) with
  | Glass { index; dispersion = Some abbe; _ }, Some l ->
      index_at ~index ~abbe l
  | ( ( Glass _ | Matte _ | Phong _ | Mirror _ | Glazed _ | Metal _ | Plastic _
      | Translucent _ | Emitter ),
      _ ) ->
      Refraction.index path m

(* Light that a camera sees in such glass meets other boundaries first. *)
let needs_one ({ hit; path; _ } : Term.vertex) =
  let { Path.wavelength; inside; _ } = path.journey in
  let m = hit.material.material in
  Option.is_none wavelength && Refraction.is_body m
  && (disperses m || List.exists disperses inside)

let term refraction : Term.t =
  let refraction : Term.t = refraction index in
  fun radiance tally ({ path; _ } as vertex) ->
    if not (needs_one vertex) then refraction radiance tally vertex
    else
      let l = wavelength (Path.one path Wavelength) in
      let colour = colour l in
      let path =
        {
          path with
          throughput = Rgb.mul path.throughput colour;
          journey = { path.journey with wavelength = Some l };
        }
      in
      Rgb.mul colour (refraction radiance tally { vertex with path })

(** Pictures of scenes, without files or domains. *)

open Candor_colour
open Candor_scene
open Candor_effect
open Candor_trace
open Candor_image

type t = { picture : Picture.t; tally : Tally.t }

(** [v s] is the picture of [s], every pixel after the other. *)
let v ?plan (s : Scene.t) =
  let pixel = Pixel.compile ?plan s and tally = Tally.make () in
  let picture =
    Picture.init ~width:s.width ~height:s.height (fun x y ->
        Pixel.radiance pixel tally ~x ~y)
  in
  { picture; tally }

let picture ?plan s = (v ?plan s).picture

(** [pixel s x y] is one pixel of [s]. *)
let pixel ?plan s x y =
  Pixel.radiance (Pixel.compile ?plan s) (Tally.make ()) ~x ~y

let bits =
  Alcotest.testable (Fmt.of_to_string (fun _ -> "a picture")) Picture.equal

(** [difference a b] says where [a] and [b] first differ, if they do. *)
let difference a b =
  if Picture.equal a b then None
  else
    let places =
      List.init
        (Picture.width a * Picture.height a)
        (fun i -> (i mod Picture.width a, i / Picture.width a))
    in
    let differ (x, y) =
      let p = Picture.pixel a x y and q = Picture.pixel b x y in
      if Rgb.equal p q then None
      else
        Some
          (Printf.sprintf "pixel %d %d: (%h %h %h) and (%h %h %h)" x y p.r p.g
             p.b q.r q.g q.b)
    in
    Some (Option.value (List.find_map differ places) ~default:"another size")

(** [same a b] is [true] iff [a] and [b] have the same bits; a law fails with
    the first pixel that has not. *)
let same a b =
  match difference a b with
  | None -> true
  | Some where -> Candor_oracle.Law.fail "%s" where

open Cmdliner
open Candor_space
open Candor_colour
open Candor_surface
open Candor_scene
open Candor_effect
open Candor_trace

let rgb (c : Rgb.t) = Printf.sprintf "(%.9g %.9g %.9g)" c.r c.g c.b
let vec (v : Vec.t) = Printf.sprintf "(%.17g %.17g %.17g)" v.x v.y v.z
let point (p : Point.t) = Printf.sprintf "(%.17g %.17g %.17g)" p.x p.y p.z
let path p = String.concat "." (List.map string_of_int p)

let side : Side.t -> string = function
  | Outside -> "outside"
  | Inside -> "inside"

let hit (h : Candor_optics.Skin.t Hit.t) =
  [
    Printf.sprintf "meets surface %s [%s] at t = %.17g, from the %s"
      (path h.path)
      (Place.to_string h.material.place)
      h.t (side h.side);
    Printf.sprintf "point %s" (point h.point);
    Printf.sprintf "normal %s" (vec (h.normal :> Vec.t));
    Printf.sprintf "the true surface is within %.3g of the point" h.offset;
  ]

let at (l : Light.t) = Place.to_string l.place

let lines : Event.t -> string list = function
  | Enter { kind; ray; throughput } ->
      [
        Printf.sprintf "%s ray, throughput %s" kind (rgb throughput);
        Printf.sprintf "from %s along %s" (point ray.origin) (vec ray.direction);
      ]
  | Met h -> hit h
  | Met_nothing -> [ "meets nothing: the background" ]
  | Shadow { light; blocked } ->
      [
        Printf.sprintf "shadow ray to the light [%s]: %s" (at light)
          (if blocked then "blocked" else "free");
      ]
  | Toward_emitter { emitter; seen } ->
      [
        Printf.sprintf "ray to the area light [%s]: %s"
          (Place.to_string emitter)
          (if seen then "met" else "not met");
      ]
  | Faces_away { light } ->
      [ Printf.sprintf "faces away from the light [%s]" (at light) ]
  | Cut Depth -> [ "reflection cut: the path is at its depth" ]
  | Cut Weight -> [ "reflection cut: throughput below the cut-off" ]
  | Term { name; radiance } -> [ Printf.sprintf "%s %s" name (rgb radiance) ]
  | Leave { radiance } -> [ Printf.sprintf "= radiance %s" (rgb radiance) ]

(* A ray's events are indented below it. *)
let print_event indent (e : Event.t) =
  let indent_by n = String.make (2 * n) ' ' in
  let print n = List.iter (fun l -> print_endline (indent_by n ^ l)) in
  match (e, lines e) with
  | Enter _, first :: rest ->
      print indent [ first ];
      print (indent + 1) rest;
      indent + 1
  | Leave _, all ->
      print indent all;
      indent - 1
  | ( ( Enter _ | Met _ | Met_nothing | Shadow _ | Toward_emitter _
      | Faces_away _ | Cut _ | Term _ ),
      all ) ->
      print indent all;
      indent

let trace pixel x y sample =
  (* Local mutation: how deep the printed tree is. *)
  let indent = ref 0 in
  let watch e = indent := print_event !indent e in
  let tally = Tally.make ~watch () in
  ignore (Pixel.sample pixel tally ~x ~y ~sample : Rgb.t)

let run file settings math x y sample =
  match Settings.read file with
  | Error status -> status
  | Ok scene ->
      let scene = Settings.apply settings scene in
      let { Scene.width; height; settings = { spp; _ }; _ } = scene in
      if x < 0 || x >= width || y < 0 || y >= height then
        Usage
          (Printf.sprintf
             "pixel %d %d is outside of the picture: X is 0 to %d, Y 0 to %d" x
             y (width - 1) (height - 1))
      else if sample < 0 || sample >= spp then
        Usage
          (Printf.sprintf "sample %d is not one of the pixel's %d, 0 to %d"
             sample spp (spp - 1))
      else (
        Printf.printf "pixel %d %d, sample %d of %d\n" x y sample spp;
        trace (Pixel.compile ~math scene) x y sample;
        Fine)

let coordinate i docv doc =
  Arg.(required & pos i (some int) None & info [] ~docv ~doc)

let x = coordinate 1 "X" "The pixel's column, from 0 at the left."
let y = coordinate 2 "Y" "The pixel's row, from 0 at the top."

let sample =
  Arg.(
    value & opt int 0
    & info [ "sample" ] ~docv:"S" ~doc:"Which of the pixel's samples, from 0.")

let man =
  [
    `S Manpage.s_description;
    `P
      "Prints the tree of rays behind one sample of one pixel: what each ray \
       meets, its weight, and the terms of the light equation there.";
  ]

let command =
  Cmd.v
    (Cmd.info "trace" ~doc:"show the rays behind one pixel" ~man
       ~exits:Status.infos)
    Cmdliner.Term.(
      const run $ Settings.scene $ Settings.term $ Settings.math $ x $ y
      $ sample)

(* The sphereflake at 1024x1024, one sample a pixel, depth 6, in POV-Ray and in
   Candor, turn by turn on the same machine. *)

open Candor_space
open Candor_colour
open Candor_surface
open Candor_scene
open Candor_render
open Candor_trace

let turns = 3

(* {1 The same scene for POV-Ray}

   What the sphereflake is made of: spheres and a box, matte and glazed, in plain
   groups, under point lights. *)

let triple x y z = Printf.sprintf "<%.17g,%.17g,%.17g>" x y z
let vec (v : Vec.t) = triple v.x v.y v.z
let point (p : Point.t) = triple p.x p.y p.z
let rgb (c : Rgb.t) = "rgb " ^ triple c.r c.g c.b

let rec plain : Texture.t -> Rgb.t = function
  | Constant c -> c
  | Checker { even = first; _ } | Noise { first; _ } -> plain first
  | Image _ -> Rgb.grey 0.5

let texture (m : Material.t) =
  let color, mirror =
    match m.kind with
    | Matte { color } | Phong { color; _ } | Plastic { color; _ } ->
        (plain color, Rgb.black)
    | Mirror { color } | Glass { color; _ } | Metal { reflectance = color; _ }
      ->
        (Rgb.black, plain color)
    | Glazed { color; mirror } -> (plain color, mirror)
    | Translucent _ | Emitter -> (Rgb.black, Rgb.black)
  in
  Printf.sprintf
    "texture { pigment { %s } finish { ambient 0 diffuse 1 reflection { %s } } \
     }"
    (rgb color) (rgb mirror)

let material (scene : Scene.t) inherited (s : Scene.surface) =
  match s.material with
  | None -> inherited
  | Some (Inline m) -> m
  | Some (Named name) ->
      let named (m : Material.t Scene.named) = m.name = name in
      Option.fold ~none:inherited
        ~some:(fun (m : Material.t Scene.named) -> m.value)
        (List.find_opt named scene.materials)

let rec surface b scene inherited (s : Scene.surface) =
  let m = material scene inherited s in
  match s.shape with
  | Sphere x ->
      Printf.bprintf b "sphere { %s, %.17g %s }\n"
        (point (Sphere.center x))
        x.radius (texture m)
  | Box x ->
      let bounds = Box.bounds x in
      Printf.bprintf b "box { %s, %s %s }\n"
        (point (Bounds.low bounds))
        (point (Bounds.high bounds))
        (texture m)
  | Group { transform = []; surfaces } -> List.iter (surface b scene m) surfaces
  | Triangle _ | Quadric _ | Polygon _ | Mesh _ | Group _ | Use _ ->
      prerr_endline "bench: a surface that was not translated for POV-Ray"

let light b (l : Light.t) =
  match l.kind with
  | Point { at; _ } ->
      Printf.bprintf b "light_source { %s rgb .6 }\n" (point at)
  | Spot _ | Directional _ ->
      prerr_endline "bench: a light that was not translated for POV-Ray"

let camera b (c : Camera.t) =
  match c.frame with
  | Perspective_angle { fov_y } ->
      Printf.bprintf b
        "camera { perspective location %s sky %s right -x up y angle %.17g \
         look_at %s }\n"
        (point c.eye) (vec c.up) fov_y (point c.look_at)
  | Perspective_window _ | Orthographic_height _ | Orthographic_window _
  | Panorama ->
      prerr_endline "bench: a camera that was not translated for POV-Ray"

let text (scene : Scene.t) =
  let b = Buffer.create 1_000_000 in
  Printf.bprintf b
    "#version 3.7; global_settings { assumed_gamma 1 max_trace_level %d \
     adc_bailout 0 }\n"
    (Scene.depth scene + 1);
  camera b scene.camera;
  List.iter (light b) scene.lights;
  List.iter (surface b scene Material.default) scene.surfaces;
  Buffer.contents b

(* {1 Measuring} *)

let capture command =
  let channel = Unix.open_process_in command in
  let text = In_channel.input_all channel in
  ignore (Unix.close_process_in channel : Unix.process_status);
  text

let installed () = Sys.command "command -v povray >/dev/null 2>&1" = 0

(* "Trace Time: 0 hours 0 minutes 6 seconds (6.363 seconds)" *)
let trace_seconds log =
  let line =
    List.find_opt
      (fun l -> String.starts_with ~prefix:"Trace Time" (String.trim l))
      (String.split_on_char '\n' log)
  in
  Option.bind line (fun l ->
      match (String.index_opt l '(', String.rindex_opt l 's') with
      | Some i, Some j when i < j ->
          float_of_string_opt (String.trim (String.sub l (i + 1) (j - i - 7)))
      | _ -> None)

let povray file domains (scene : Scene.t) =
  trace_seconds
    (capture
       (Printf.sprintf "povray +I%s +O/dev/null +W%d +H%d +WT%d -A -D 2>&1"
          (Filename.quote file) scene.width scene.height domains))

let candor domains scene =
  Option.map
    (fun (r : Render.report) -> r.seconds)
    (Render.run ~domains (Pixel.compile scene) scene)

let turn file scene i =
  let domains = 2 in
  match (povray file domains scene, candor domains scene) with
  | Some p, Some c ->
      Printf.printf "%4d %12.2f %12.2f %8.2f\n%!" i p c (c /. p);
      Some (c /. p)
  | _ ->
      Printf.printf "%4d  could not be measured\n%!" i;
      None

let table folder =
  let scene = Load.named folder "sphereflake-flat" in
  let settings = { scene.settings with spp = 1; depth = Some 6 } in
  let scene = { scene with width = 1024; height = 1024; settings } in
  if not (installed ()) then print_endline "POV-Ray is not installed: skipped."
  else
    let file = Filename.temp_file "candor" ".pov" in
    Out_channel.with_open_bin file (fun c -> output_string c (text scene));
    Printf.printf "%4s %12s %12s %8s\n" "turn" "POV-Ray s" "Candor s" "ratio";
    let ratios = List.filter_map (turn file scene) (List.init turns succ) in
    Sys.remove file;
    match List.sort Float.compare ratios with
    | [] -> ()
    | sorted ->
        Printf.printf "median ratio %.2f (wanted: at most 3)\n"
          (List.nth sorted (List.length sorted / 2))

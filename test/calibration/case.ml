(* The scenes that are rendered again and again, small. *)

open Candor_scene
open Candor_read
open Candor_trace

type t = {
  scene : Scene.t;
  name : string;
  spp : int list;  (** fixed numbers of samples that are tried *)
}

let folder = Filename.(concat (dirname Sys.executable_name) "../../scenes")

let read name =
  let path = Filename.concat folder (name ^ ".scene") in
  match Scene_file.read path with
  | Ok scene -> scene
  | Error report ->
      Format.eprintf "%a%!" Error.pp_report report;
      exit 1

let sized ~width ~height name = { (read name) with width; height }

let case ?(width = 48) ?(height = 36) spp name =
  { scene = sized ~width ~height name; name; spp }

(* What takes longer is smaller. *)
let slow = case ~width:32 ~height:24 [ 16 ]
let usual = case [ 16 ]
let twice = case [ 16; 64 ]

let all () =
  List.map twice [ "beams"; "caustics"; "shadows"; "sun"; "textures" ]
  @ List.map usual
      [
        "amber";
        "cornell";
        "focus";
        "glazed-floor";
        "glints";
        "gloss";
        "hero";
        "jade";
        "keyhole";
        "lamps";
        "mirror";
        "mist";
        "overcast";
        "penumbra";
        "prism";
        "quadrics";
        "shutter";
        "spot-lights";
        "window";
      ]
  @ List.map slow [ "diamond"; "glass"; "smallpt"; "sphereflake" ]

(** [pixel scene seed] is [scene] made ready, with [seed] for all that is
    random. *)
let pixel (scene : Scene.t) seed =
  Pixel.compile { scene with settings = { scene.settings with seed } }

(** [runs] is how many seeds are tried: 100, or as many as the variable
    CALIBRATION_SEEDS of the environment says. *)
let runs =
  match Option.bind (Sys.getenv_opt "CALIBRATION_SEEDS") int_of_string_opt with
  | Some n when n >= 1 -> n
  | Some _ | None -> 100

(* Peak memory and time to load and render many spheres, each number in a process
   of its own. *)

open Candor_render
open Candor_trace

let write file n =
  (* A lattice shaken by a fixed multiplicative sequence. *)
  let at i k = (Float.rem (float_of_int i *. k) 1. *. 120.) -. 60. in
  Out_channel.with_open_bin file (fun c ->
      output_string c
        "(scene (image (size 160 120))\n\
         (camera (perspective (eye 0 0 200) (look-at 0 0 0) (fov-y 40)))\n\
         (light (directional (direction -1 -1 -1) (irradiance 3)))\n";
      for i = 1 to n do
        Printf.fprintf c "(sphere (center %.3f %.3f %.3f) (radius .25))\n"
          (at i 0.8191725133961645) (at i 0.6710436067037893)
          (at i 0.5497004779019703)
      done;
      output_string c ")\n")

(* The most memory this process ever had, as Linux counts it. *)
let peak_bytes () =
  let lines =
    String.split_on_char '\n'
      (In_channel.with_open_bin "/proc/self/status" In_channel.input_all)
  in
  List.find_map
    (fun l ->
      match Scanf.sscanf_opt l "VmHWM: %f kB" Fun.id with
      | Some kb -> Some (1024. *. kb)
      | None -> None)
    lines

let child n =
  let file = Filename.temp_file "candor" ".scene" in
  write file n;
  let scene, reading = Load.timed (fun () -> Load.scene file) in
  Sys.remove file;
  let pixel, building = Load.timed (fun () -> Pixel.compile scene) in
  let _, rendering = Load.timed (fun () -> Render.run pixel scene) in
  match peak_bytes () with
  | None -> print_endline "peak memory is not known on this system"
  | Some peak ->
      let mb = 1e-6 *. peak in
      let allowed = 50. +. (500e-6 *. float_of_int n) in
      Printf.printf "%9d %8.2f %8.2f %10.2f %10.1f %10.1f  %s\n%!" n reading
        building rendering mb allowed
        (if mb <= allowed then "ok" else "TOO MUCH")

let table () =
  Printf.printf "%9s %8s %8s %10s %10s %10s\n%!" "spheres" "read s" "build s"
    "render s" "peak MB" "allowed MB";
  List.iter
    (fun n ->
      ignore
        (Sys.command
           (Filename.quote_command Sys.executable_name
              [ "memory"; string_of_int n ])
          : int))
    [ 10_000; 100_000; 1_000_000 ]

(** Hits, and what terms make of them. *)

open Candor_space
open Candor_colour
open Candor_surface
open Candor_effect
open Candor_scene_made

let rgb = Alcotest.testable (Fmt.of_to_string Rgb.show) Rgb.equal

let close ?(within = 1e-14) a b =
  Float.abs (a -. b) <= within *. Float.max 1. (Float.abs b)

let close_rgb ?within (a : Rgb.t) (b : Rgb.t) =
  close ?within a.r b.r && close ?within a.g b.g && close ?within a.b b.b

let check_close ?within name (expected : Rgb.t) (actual : Rgb.t) =
  if not (close_rgb ?within actual expected) then
    Alcotest.failf "%s: expected %s, got %s" name (Rgb.show expected)
      (Rgb.show actual)

let scene forms = Written.scene (Written.flat_camera :: forms)
let ray (ox, oy, oz) (dx, dy, dz) = Ray.v (Point.v ox oy oz) (Vec.v dx dy dz)

(** [hit s o d] is what the ray from [o] along [d] meets. *)
let hit scene o d =
  match Surface.nearest (Candor_optics.Skin.surface scene) (ray o d) with
  | Some hit -> hit
  | None -> Alcotest.fail "the ray meets nothing"

let vertex ?(path = Path.start) (hit : Tracer.hit) view : Term.vertex =
  let lobes = hit.material.lobes hit.local ~normal:hit.shading_normal ~view in
  { hit; view; lobes; path }

(** [tracer s] sees the surfaces of [s]. *)
let tracer scene = Tracer.still (Candor_optics.Skin.surface scene)

(** What a term must not ask for. *)
let no_recursion : Term.radiance =
 fun _ ~kind:_ _ _ -> Alcotest.fail "a ray was followed"

(** [events s (x, y)] is what happens along the first camera ray of that pixel,
    and the tally. *)
let events scene (x, y) =
  let seen = ref [] in
  let tally = Tally.make ~watch:(fun e -> seen := e :: !seen) () in
  let pixel = Candor_trace.Pixel.compile scene in
  ignore (Candor_trace.Pixel.sample pixel tally ~x ~y ~sample:0 : Rgb.t);
  (List.rev !seen, tally)

let rendered ?plan s = Shot.v ?plan s

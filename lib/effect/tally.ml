open Candor_colour
open Candor_surface

type counter =
  | Camera_rays
  | Shadow_rays
  | Mirror_rays
  | Refraction_rays
  | Bounce_rays
  | Emitter_rays
  | Sky_rays
  | Scattered_rays
  | Cut_by_depth
  | Cut_by_weight
  | Non_finite
  | Spared_samples
[@@deriving show, eq, ord]

let rays =
  [
    Camera_rays;
    Shadow_rays;
    Mirror_rays;
    Refraction_rays;
    Bounce_rays;
    Emitter_rays;
    Sky_rays;
    Scattered_rays;
  ]

let counters =
  rays @ [ Cut_by_depth; Cut_by_weight; Non_finite; Spared_samples ]

let name = function
  | Camera_rays -> "camera"
  | Shadow_rays -> "shadow"
  | Mirror_rays -> "mirror"
  | Refraction_rays -> "refraction"
  | Bounce_rays -> "bounce"
  | Emitter_rays -> "emitter"
  | Sky_rays -> "sky"
  | Scattered_rays -> "scattered"
  | Cut_by_depth -> "cut_by_depth"
  | Cut_by_weight -> "cut_by_weight"
  | Non_finite -> "non_finite"
  | Spared_samples -> "spared_samples"

let index = function
  | Camera_rays -> 0
  | Shadow_rays -> 1
  | Mirror_rays -> 2
  | Refraction_rays -> 3
  | Bounce_rays -> 4
  | Emitter_rays -> 5
  | Sky_rays -> 6
  | Scattered_rays -> 7
  | Cut_by_depth -> 8
  | Cut_by_weight -> 9
  | Non_finite -> 10
  | Spared_samples -> 11

type t = {
  counts : int array;
  left_out : floatarray;  (** red, green and blue *)
  effort : Effort.t;
  watch : (Event.t -> unit) option;
}

let make ?watch () =
  {
    counts = Array.make (List.length counters) 0;
    left_out = Float.Array.make 3 0.;
    effort = Effort.make ();
    watch;
  }

let count t c =
  let i = index c in
  t.counts.(i) <- t.counts.(i) + 1

let get t c = t.counts.(index c)

let leave_out t ~(carried : Rgb.t) (weight : Rgb.t) =
  let sum = t.left_out in
  Float.Array.set sum 0 (Float.Array.get sum 0 +. (carried.r *. weight.r));
  Float.Array.set sum 1 (Float.Array.get sum 1 +. (carried.g *. weight.g));
  Float.Array.set sum 2 (Float.Array.get sum 2 +. (carried.b *. weight.b))

let left_out t =
  let sum = t.left_out in
  Rgb.v (Float.Array.get sum 0) (Float.Array.get sum 1) (Float.Array.get sum 2)

let start_anew t = Float.Array.fill t.left_out 0 3 0.

let move_left_out t a i =
  for k = 0 to 2 do
    Float.Array.set a (i + k)
      (Float.Array.get a (i + k) +. Float.Array.get t.left_out k)
  done;
  start_anew t

(* Without a closure: it is asked for every pixel. *)
let rec sum_of t n = function
  | [] -> n
  | c :: others -> sum_of t (n + get t c) others

let total_rays t = sum_of t 0 rays
let effort t = t.effort

let sum ts =
  let total i = List.fold_left (fun n t -> n + t.counts.(i)) 0 ts
  and lost i =
    List.fold_left (fun x t -> x +. Float.Array.get t.left_out i) 0. ts
  in
  {
    counts = Array.init (List.length counters) total;
    left_out = Float.Array.init 3 lost;
    effort = Effort.sum (List.map effort ts);
    watch = None;
  }

let watched t = Option.is_some t.watch
let show t e = match t.watch with Some f -> f e | None -> ()

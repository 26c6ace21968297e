open Candor_surface

type counter =
  | Camera_rays
  | Shadow_rays
  | Mirror_rays
  | Cut_by_depth
  | Cut_by_weight
  | Non_finite
[@@deriving show, eq, ord]

let rays = [ Camera_rays; Shadow_rays; Mirror_rays ]
let counters = rays @ [ Cut_by_depth; Cut_by_weight; Non_finite ]

let name = function
  | Camera_rays -> "camera"
  | Shadow_rays -> "shadow"
  | Mirror_rays -> "mirror"
  | Cut_by_depth -> "cut_by_depth"
  | Cut_by_weight -> "cut_by_weight"
  | Non_finite -> "non_finite"

let index = function
  | Camera_rays -> 0
  | Shadow_rays -> 1
  | Mirror_rays -> 2
  | Cut_by_depth -> 3
  | Cut_by_weight -> 4
  | Non_finite -> 5

type t = {
  counts : int array;
  effort : Effort.t;
  watch : (Event.t -> unit) option;
}

let make ?watch () =
  {
    counts = Array.make (List.length counters) 0;
    effort = Effort.make ();
    watch;
  }

let count t c =
  let i = index c in
  t.counts.(i) <- t.counts.(i) + 1

let get t c = t.counts.(index c)
let effort t = t.effort

let sum ts =
  let total i = List.fold_left (fun n t -> n + t.counts.(i)) 0 ts in
  {
    counts = Array.init (List.length counters) total;
    effort = Effort.sum (List.map effort ts);
    watch = None;
  }

let watched t = Option.is_some t.watch
let show t e = match t.watch with Some f -> f e | None -> ()

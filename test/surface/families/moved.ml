(** Surfaces that move, with rays that go along with them. *)

open Candor_space
open Candor_surface
open Candor_oracle
open QCheck2

type t = {
  case : Shapes.t Family.case;
  velocity : Vec.t;
  shutter : float * float;
  time : float;  (** within the shutter *)
}

let show m =
  Printf.sprintf "%s\nby %s in [%h;%h], at %h" (Shapes.show_case m.case)
    (Draw.show_vec m.velocity) (fst m.shutter) (snd m.shutter) m.time

(** [within shutter] is a time at which it is open. *)
let within (a, b) =
  Gen.oneof
    [
      Gen.return a;
      Gen.return b;
      Gen.map
        (fun k -> Float.max a (Float.min b (a +. (k *. (b -. a)))))
        (Draw.uniform 0. 1.);
    ]

let shutter =
  let open Gen in
  oneof
    [
      return (0., 1.);
      (let* a = Draw.uniform (-3.) 3. and* long = Draw.wide (-9.) 1. in
       return (a, a +. long));
      map (fun a -> (a, a)) (Draw.uniform (-3.) 3.);
    ]

let velocity =
  let open Gen in
  oneof
    [
      Draw.vec (Draw.uniform (-9.) 9.);
      Draw.axial;
      Draw.vec (Draw.small 4);
      Draw.vec (Draw.signed (Draw.wide (-20.) 6.));
    ]

(** [moved_from cases] are surfaces that move. The ray goes along with the
    surface, so that it meets it as often. *)
let moved_from cases =
  let open Gen in
  let* { Family.shape; ray } = cases and* shutter = shutter in
  let* velocity = velocity and* time = within shutter in
  let origin = Point.add ray.origin (Vec.scale time velocity) in
  let ray = Ray.v origin ray.direction in
  return { case = { shape; ray }; velocity; shutter; time }

let moved = moved_from Shapes.case
let ray = Gen.map (fun m -> m.case.ray) moved

(** [at_times] are surfaces that move, with times while the shutter is open. *)
let at_times =
  let open Gen in
  let* m = moved in
  let* times = list_size (return 5) (within m.shutter) in
  return (m, times)

(** [moving m s] is [s] moving as [m] says. *)
let moving { velocity; shutter; _ } s = Surface.moving ~velocity ~shutter s

let transform steps = Made.get "transform" (Transform.of_steps steps)

(** [translated m s] is [s] in a group that stands where [m] has moved it. *)
let translated { velocity; time; _ } s =
  let transform = transform [ Translate (Vec.scale time velocity) ] in
  Surface.seen_through ~transform (Surface.group [| s |])

(** Families for surfaces within groups, one in the other. *)

open Candor_space
open Candor_surface
open Candor_oracle
open QCheck2.Gen
open Draw
open Made

type t = { leaf : Shapes.t; maps : Affine.t list; surface : unit Surface.t }
(** [maps] outermost first *)

let make leaf maps =
  let around inner m =
    let transform = get "transform" (Transform.of_steps [ Matrix m ]) in
    Surface.seen_through ~transform (Surface.group [| inner |])
  in
  let inner = Shapes.surface () leaf in
  { leaf; maps; surface = List.fold_left around inner (List.rev maps) }

let show_map (m : Affine.t) =
  Printf.sprintf "(%h %h %h %h  %h %h %h %h  %h %h %h %h)" m.xx m.xy m.xz m.xt
    m.yx m.yy m.yz m.yt m.zx m.zy m.zz m.zt

(** [kind ~blur] forgives [blur] of the sizes that add up to a coordinate in the
    space of each group. *)
let kind ~blur =
  {
    Family.show =
      (fun s ->
        String.concat "\n in "
          (Shapes.show s.leaf :: List.rev_map show_map s.maps));
    answer = (fun s -> answer s.surface);
    truth =
      (fun s line -> Shapes.truth s.leaf (Exact_map.into ~blur s.maps line));
  }

let family name cases = { Family.name; cases }
let case shape ray = { Family.shape; ray }

(* {1 Maps} *)

let linear (x : Vec.t) (y : Vec.t) (z : Vec.t) (t : Vec.t) =
  {
    Affine.xx = x.x;
    xy = x.y;
    xz = x.z;
    xt = t.x;
    yx = y.x;
    yy = y.y;
    yz = y.z;
    yt = t.y;
    zx = z.x;
    zy = z.y;
    zz = z.z;
    zt = t.z;
  }

(* Turned, stretched by [s] along the turned axes, and moved. *)
let turned (s : Vec.t) t =
  let* w = unit in
  let+ u = across w in
  let v' = Vec.cross w u in
  linear (Vec.scale s.x u) (Vec.scale s.y v') (Vec.scale s.z w) t

let mild =
  let* s = vec (uniform 0.5 2.) and* t = vec (uniform (-2.) 2.) in
  turned s t

let uneven =
  let* s = vec (signed (wide (-2.) 2.)) and* t = vec (uniform (-9.) 9.) in
  turned s t

(* Powers of two and whole numbers, axes swapped: nothing is rounded. *)
let exact =
  let* s = vec (signed (power (-3) 3)) and* t = vec (small 4) in
  let* turn = int_bound 2 in
  let x = v s.x 0. 0. and y = v 0. s.y 0. and z = v 0. 0. s.z in
  return
    (if turn = 0 then linear x y z t
     else if turn = 1 then linear y z x t
     else linear z x y t)

(* {1 Cases} *)

let leaf =
  oneof
    [
      return (Shapes.Sphere Spheres.unit_sphere);
      map (fun s -> Shapes.Triangle s) Triangles.random;
      map
        (fun b -> Shapes.Box b)
        (Boxes.box_of (point (map (fun x -> x /. 2.) (small 4))));
    ]

let outwards (q : Point.t) (m : Affine.t) =
  p
    ((m.xx *. q.x) +. (m.xy *. q.y) +. (m.xz *. q.z) +. m.xt)
    ((m.yx *. q.x) +. (m.yy *. q.y) +. (m.yz *. q.z) +. m.yt)
    ((m.zx *. q.x) +. (m.zy *. q.y) +. (m.zz *. q.z) +. m.zt)

(* Aimed at a place of the leaf from a few of its sizes away. *)
let within name depth map =
  let shapes =
    pool 500
      (let* n = depth and* leaf = leaf in
       let+ maps = list_size (return n) map in
       make leaf maps)
  in
  family name
    (let* ({ leaf; maps; _ } as shape) = shapes in
     let out q = List.fold_left outwards q (List.rev maps) in
     let* target = Shapes.target leaf in
     let* away = unit and* far = wide (-1.) 2. in
     let o = out (move target away far) and target = out target in
     let d = toward o target in
     let d = if Vec.largest d > 0. then d else v 1. 0. 0. in
     return (case shape (Ray.v o d)))

(* 1e-8 within 1e8 and so on, turned each time. *)
let shrinking =
  let map =
    let* k = pick [ 1e-8; 1e8 ] and* t = vec (uniform (-1.) 1.) in
    turned (v k k k) t
  in
  within "G1 groups that shrink and grow by 1e8, 1 to 10 deep" (int_range 1 10)
    map

let all =
  [
    within "one group, turned and moved" (return 1) mild;
    within "groups in groups, 2 to 10 deep" (int_range 2 10) mild;
    within "uneven scales of 1e-2..1e2, mirrored, 1 to 5 deep" (int_range 1 5)
      uneven;
    within "powers of two and whole numbers, 1 to 10 deep" (int_range 1 10)
      exact;
    shrinking;
  ]

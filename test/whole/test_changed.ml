open Candor_space
open Candor_surface
open Candor_scene
open Candor_oracle
open Candor_surface_families
open Candor_scene_made
open QCheck2

let law ?(count = 200) name gen holds =
  Law.law ~count
    ~print:(fun (s, _) -> Drawn.show s)
    name
    (Gen.pair (Gen.no_shrink gen) Gen.int)
    (fun (s, seed) -> holds s (Random.State.make [| seed |]))

(* {1 Rays} *)

let number rand size = Random.State.float rand (2. *. size) -. size

(* Half of all coordinates are halves: on faces, through edges and corners. *)
let coordinate rand size =
  let x = number rand size in
  if Random.State.bool rand then Float.round (2. *. x) /. 2. else x

let point rand size =
  let a = coordinate rand size in
  let b = coordinate rand size in
  Point.v a b (coordinate rand size)

let along_axis rand =
  let s = if Random.State.bool rand then 1. else -1. in
  match Random.State.int rand 3 with
  | 0 -> Vec.v s 0. 0.
  | 1 -> Vec.v 0. s 0.
  | _ -> Vec.v 0. 0. s

(* Towards where the surfaces are. *)
let ray rand =
  let goal = point rand 2.5 in
  let o =
    if Random.State.int rand 4 = 0 then
      Point.add goal (Vec.scale (-8.) (along_axis rand))
    else point rand 6.
  in
  let d = Point.sub goal o in
  Ray.v o (if Vec.largest d > 0. then d else along_axis rand)

(* No coordinate of few digits, so that nothing is met exactly on an edge. *)
let loose_ray rand =
  let point size =
    let a = number rand size in
    let b = number rand size in
    Point.v a b (number rand size)
  in
  let o = point 6. in
  Ray.v o (Point.sub (point 2.5) o)

let times n f =
  for _ = 1 to n do
    f ()
  done;
  true

let show_hit = function
  | None -> "nothing"
  | Some (h : _ Hit.t) ->
      Printf.sprintf "%s at t = %h, point %s, normal %s"
        (String.concat "." (List.map string_of_int h.path))
        h.t (Draw.show_point h.point)
        (Draw.show_vec (h.normal :> Vec.t))

let differ what ray a b =
  Law.fail "%s, %s: %s became %s" what (Draw.show_ray ray) (show_hit a)
    (show_hit b)

(* {1 Changes that change no bit} *)

(* [same a b] of the hits before and after; both may be none. *)
let agree what ray same before after =
  let right =
    match (before, after) with
    | None, None -> true
    | Some a, Some b -> same a b
    | None, Some _ | Some _, None -> false
  in
  if not right then ignore (differ what ray before after : bool)

let longer s rand =
  let surface = Assembly.surface ~dress:Fun.id s in
  times 25 (fun () ->
      let ray = ray rand in
      let k = Float.ldexp 1. (Random.State.int rand 121 - 60) in
      let same (a : _ Hit.t) (b : _ Hit.t) =
        a.path = b.path
        && a.t = k *. b.t
        && Point.equal a.point b.point
        && Dir.equal a.normal b.normal
      in
      agree "a longer direction" ray same
        (Surface.nearest surface ray)
        (Surface.nearest surface
           { ray with direction = Vec.scale k ray.direction }))

let mirrored s rand =
  let change = Shapes.mirror (Random.State.int rand 3) in
  let s, s' = Mirrored.both change s in
  let surface = Assembly.surface ~dress:Fun.id s
  and surface' = Assembly.surface ~dress:Fun.id s' in
  times 25 (fun () ->
      let ray = loose_ray rand in
      let same (a : _ Hit.t) (b : _ Hit.t) =
        a.path = b.path && a.t = b.t
        && Point.equal (change.point a.point) b.point
        && Vec.equal (change.normal (a.normal :> Vec.t)) (b.normal :> Vec.t)
      in
      agree "mirrored" ray same
        (Surface.nearest surface ray)
        (Surface.nearest surface' (Shapes.change_ray change ray)))

(* {1 The hierarchy} *)

let rays_each = 5_000

(* The least by (t, place) of all simple surfaces, each asked alone. *)
let scanned s rand =
  let whole = Assembly.surface ~dress:Fun.id s in
  let leaves =
    List.map
      (fun { Flattened.path; alone } ->
        (path, Assembly.surface ~dress:Fun.id alone))
      (Flattened.leaves s)
  in
  let least ray =
    List.fold_left
      (fun best (path, leaf) ->
        match (best, Surface.nearest leaf ray) with
        | Some (t, _), Some (h : _ Hit.t) when t <= h.t -> best
        | _, Some h -> Some (h.t, path)
        | _, None -> best)
      None leaves
  in
  times rays_each (fun () ->
      let ray = ray rand in
      let expected = least ray in
      let found = Surface.nearest whole ray in
      if Option.map (fun (h : _ Hit.t) -> (h.t, h.path)) found <> expected then
        ignore
          (Law.fail "%s: found %s, the scan %s" (Draw.show_ray ray)
             (show_hit found)
             (match expected with
             | None -> "nothing"
             | Some (t, path) ->
                 Printf.sprintf "%s at %h"
                   (String.concat "." (List.map string_of_int path))
                   t)
            : bool))

(* {1 A box and its twelve triangles} *)

let triangles (b : Bounds.t) =
  let between lo hi x = if x < 0. then lo else hi in
  let place (q : Point.t) =
    Point.v (between b.x0 b.x1 q.x) (between b.y0 b.y1 q.y)
      (between b.z0 b.z1 q.z)
  in
  Mesh.triangles (Mesh.moved place Mesh.cube)

(* From when until when the line is in the open inside of the box, if at all. *)
type passage = Through of Q.t * Q.t | Touching | Past

let passage (b : Bounds.t) (ray : Ray.t) =
  let slab lo hi o d =
    let lo = Exact.q lo and hi = Exact.q hi in
    let o = Exact.q o and d = Exact.q d in
    if Q.sign d <> 0 then
      let a = Q.div (Q.sub lo o) d and b = Q.div (Q.sub hi o) d in
      Through (Q.min a b, Q.max a b)
    else if Q.lt lo o && Q.lt o hi then Through (Q.minus_inf, Q.inf)
    else if Q.leq lo o && Q.leq o hi then Touching
    else Past
  in
  let both a b =
    match (a, b) with
    | Past, _ | _, Past -> Past
    | Touching, _ | _, Touching -> Touching
    | Through (n, f), Through (n', f') ->
        let near = Q.max n n' and far = Q.min f f' in
        if Q.lt near far then Through (near, far)
        else if Q.equal near far then Touching
        else Past
  in
  let o = ray.origin and d = ray.direction in
  match
    both (slab b.x0 b.x1 o.x d.x)
      (both (slab b.y0 b.y1 o.y d.y) (slab b.z0 b.z1 o.z d.z))
  with
  | Through (_, far) when Q.sign far <= 0 -> Past
  | passage -> passage

let flat (b : Bounds.t) = b.x0 = b.x1 || b.y0 = b.y1 || b.z0 = b.z1

(* 2 ulp of the box, 4 ulp of the triangle, and 2^-96 of the distances. *)
let allowed (b : Bounds.t) (ray : Ray.t) t =
  let reach p = Vec.largest (Point.sub p ray.origin) in
  let far = reach (Bounds.low b) +. reach (Bounds.high b) in
  (6. *. Exact.ulp t) +. (0x1p-94 *. far /. Vec.largest ray.direction)

let box_is_triangles { Family.shape = box; ray } =
  let b = (box : Box.t :> Bounds.t) in
  flat b
  ||
  let mesh =
    Surface.group (Array.map (fun s -> Surface.triangle s ()) (triangles b))
  in
  let met = Surface.nearest (Surface.box box ()) ray in
  let met' = Surface.nearest mesh ray in
  match (passage b ray, met, met') with
  | Touching, _, _ -> true
  | Past, None, None -> true
  | Through (near, far), Some h, Some h' ->
      let allowed = allowed b ray h.t in
      (* Where it is through at once, either side may come first. *)
      let at_once = Q.leq (Q.sub far near) (Exact.q allowed) in
      (Float.abs (h.t -. h'.t) <= allowed && (h.side = h'.side || at_once))
      || differ "triangles" ray met met'
  | (Past | Through _), _, _ -> differ "triangles" ray met met'

let boxes { Family.name; cases } =
  Law.law ~count:20_000 ~print:(Family.show Boxes.kind)
    ("a box is met like its twelve triangles, within 6 ulp: " ^ name)
    cases box_is_triangles

let suite =
  ( "scenes changed",
    [
      law ~count:4000
        "directions 2^-60 to 2^60 as long meet the same at t 2^60 to 2^-60"
        (Drawn.scene Round) longer;
      law ~count:4000
        "mirroring an axis leaves t and mirrors point and normal, in groups too"
        (Drawn.scene Loose) mirrored;
      law ~count:200
        "G8 G9: 1,000,000 rays meet a scene like a scan of its surfaces: same \
         place, same t"
        (Drawn.scene ~most:12 Round)
        scanned;
    ]
    @ List.map boxes Boxes.[ aimed; whole; through ] )

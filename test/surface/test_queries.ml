open Candor_space
open Candor_surface
open Candor_oracle
open Candor_surface_families
open QCheck2

(* What two hits of one surface have in common wherever it stands. *)
type seen = { t : float; side : Side.t; part : int; place : int }

let seen (h : int Hit.t) =
  { t = h.t; side = h.side; part = h.part; place = h.material }

let show_seen = function
  | None -> "nothing"
  | Some s ->
      Printf.sprintf "surface %d part %d %s at t = %h" s.place s.part
        (Side.show s.side) s.t

let same what expected found =
  expected = found
  || Law.fail "%s: expected %s, found %s" what (show_seen expected)
       (show_seen found)

let nearest ?limit s ray = Option.map seen (Surface.nearest s ?limit ray)

(* {1 Groups} *)

(* The least by (t, place), each surface asked alone. *)
let linear_scan ?limit shapes ray =
  let ask i s = nearest ?limit (Shapes.surface i s) ray in
  Array.mapi ask shapes |> Array.to_seq |> Seq.filter_map Fun.id
  |> Seq.fold_left
       (fun best s ->
         match best with Some b when b.t <= s.t -> best | _ -> Some s)
       None

let scan_agrees { Shapes.shapes; ray } =
  let group = Shapes.group shapes in
  let expected = linear_scan shapes ray in
  let limits =
    match expected with
    | None -> [ infinity; 1. ]
    | Some { t; _ } -> [ infinity; t; Float.pred t; t /. 2. ]
  in
  List.for_all
    (fun limit ->
      let expected = linear_scan ~limit shapes ray in
      same (Printf.sprintf "up to %h" limit) expected (nearest ~limit group ray)
      && Surface.blocked group ~limit ray = Option.is_some expected)
    limits

let asks_for_a_kind { Shapes.shapes; ray } =
  let alone kind =
    let meets i s =
      kind i && Surface.blocked (Shapes.surface i s) ~limit:infinity ray
    in
    Array.exists Fun.id (Array.mapi meets shapes)
  and group = Shapes.group shapes in
  List.for_all
    (fun kind -> Surface.meets_any group kind ray = alone kind)
    [ (fun i -> i mod 2 = 0); (fun i -> i mod 3 = 1); Fun.const true ]

let path_is_place { Shapes.shapes; ray } =
  match Surface.nearest (Shapes.group shapes) ray with
  | None -> true
  | Some h -> h.path = [ h.material ]

(* Surfaces in another order: the same one is found, but in a tie. *)
let permuted ({ Shapes.shapes; ray }, seed) =
  let n = Array.length shapes in
  let order = Array.init n Fun.id in
  Array.shuffle ~rand:(Random.State.int (Random.State.make [| seed |])) order;
  let shuffled =
    Surface.group (Array.map (fun i -> Shapes.surface i shapes.(i)) order)
  in
  let expected = nearest (Shapes.group shapes) ray in
  let found = nearest shuffled ray in
  match (expected, found) with
  | Some a, Some b when a.place <> b.place ->
      (* Then they tie. *)
      a.t = b.t
      && nearest (Shapes.surface b.place shapes.(b.place)) ray = Some b
  | _ -> same "shuffled" expected found

(* {1 Exact changes} *)

let exactly_scaled ({ Family.shape; ray }, k) =
  let c = Shapes.scaling k in
  match Shapes.change c shape with
  | None -> true
  | Some scaled -> (
      let before = Surface.nearest (Shapes.surface 0 shape) ray
      and after =
        Surface.nearest (Shapes.surface 0 scaled) (Shapes.change_ray c ray)
      in
      match (before, after) with
      | None, None -> true
      | Some a, Some b ->
          let lengthen (h : _ Hit.t) =
            Some { (seen h) with t = h.t *. c.length }
          in
          same "scaled" (lengthen a) (Some (seen b))
          && Point.equal (c.point a.point) b.point
          && Dir.equal a.normal b.normal
          && Float.equal (a.offset *. c.length) b.offset
      | _ -> same "scaled" (Option.map seen before) (Option.map seen after))

let direction_scaled ({ Family.shape; ray }, k) =
  let by = Float.ldexp 1. k in
  let longer = Ray.v ray.origin (Vec.scale by ray.direction) in
  let s = Shapes.surface 0 shape in
  match (nearest s ray, nearest s longer) with
  | Some a, b -> same "along 2^k d" (Some { a with t = a.t /. by }) b
  | None, b -> same "along 2^k d" None b

let mirrored ({ Family.shape; ray }, axis) =
  let c = Shapes.mirror axis in
  match Shapes.change c shape with
  | None -> true
  | Some shape' -> (
      let before = Surface.nearest (Shapes.surface 0 shape) ray
      and after =
        Surface.nearest (Shapes.surface 0 shape') (Shapes.change_ray c ray)
      in
      match (before, after) with
      | Some a, Some b ->
          let same what x y =
            Vec.equal (c.normal x) y
            || Law.fail "the %s %s became %s" what (Draw.show_vec x)
                 (Draw.show_vec y)
          in
          let at (p : Point.t) = Point.sub p Point.origin in
          (a.t = b.t || Law.fail "t = %h became %h" a.t b.t)
          && same "point" (at a.point) (at b.point)
          && same "normal" (a.normal :> Vec.t) (b.normal :> Vec.t)
      | None, None -> true
      | _ -> same "mirrored" (Option.map seen before) (Option.map seen after))

(* Away from ties: those of triangles break by the axes, and -0 is another
   number. *)
let no_ties =
  Gen.map
    (fun ({ Family.shape; ray } as case) ->
      match shape with
      | Shapes.Triangle s ->
          let e =
            Exact_triangle.(
              let a, b, c = corners s in
              let o = Exact.point ray.origin and d = Exact.vec ray.direction in
              let a = Exact.sub a o
              and b = Exact.sub b o
              and c = Exact.sub c o in
              List.exists
                (fun (p, q) -> Q.sign (Exact.dot d (Exact.cross p q)) = 0)
                [ (a, b); (b, c); (c, a) ])
          in
          if e then { case with ray = Ray.v ray.origin (Vec.v 0.3 0.5 0.7) }
          else case
      | _ -> case)
    Shapes.case

(* {1 Nesting} *)

let rec nested depth s =
  if depth = 0 then s else nested (depth - 1) (Surface.group [| s |])

let deep () =
  let sphere = Surface.sphere (Made.sphere (Point.v 0. 0. 5.) 1.) 0 in
  let ray = Ray.v Point.origin (Vec.v 0. 0. 1.) in
  match Surface.nearest (nested 1000 sphere) ray with
  | None -> Alcotest.fail "lost in 1,000 groups"
  | Some h ->
      Alcotest.(check (float 0.)) "t" 4. h.t;
      Alcotest.(check (list int)) "path" (List.init 1000 (fun _ -> 0)) h.path;
      Alcotest.(check bool)
        "leaving it outwards meets nothing" true
        (Surface.nearest (nested 1000 sphere) (Hit.spawn h (Vec.v 0. 0.1 (-1.)))
        = None)

let split_anywhere ({ Shapes.shapes; ray }, cut) =
  let n = Array.length shapes in
  let cut = cut mod (n + 1) in
  let part from until =
    Surface.group
      (Array.init (until - from) (fun i ->
           Shapes.surface (from + i) shapes.(from + i)))
  in
  let two = Surface.group [| part 0 cut; nested 3 (part cut n) |] in
  same "in groups" (nearest (Shapes.group shapes) ray) (nearest two ray)

let transform steps = Made.get "transform" (Transform.of_steps steps)

let moved_by_whole_numbers ({ Shapes.shapes; ray }, offsets) =
  (* Translations that round nothing: numbers of few bits. *)
  let few x = Float.round (x *. 64.) /. 64. in
  let place (p : Point.t) = Point.v (few p.x) (few p.y) (few p.z) in
  let total = List.fold_left Vec.add Vec.zero offsets in
  let s = shapes.(0) in
  match s with
  | Shapes.Sphere s ->
      let c = place (Sphere.center s) and r = s.radius in
      let ray = Ray.v (place ray.origin) ray.direction in
      let flat = Surface.sphere (Made.sphere (Point.add c total) r) 0 in
      let deep =
        List.fold_left
          (fun s v ->
            Surface.seen_through
              ~transform:(transform [ Translate v ])
              (Surface.group [| s |]))
          (Surface.sphere (Made.sphere c r) 0)
          offsets
      in
      same "translated" (nearest flat ray) (nearest deep ray)
  | _ -> true

(* The exact inverse image of a line under a map of pairs of doubles. *)
let exactly_back transform line =
  let { Wide_affine.high = m; low = l } = Transform.forward transform in
  let open Exact in
  let v (x, x') (y, y') (z, z') = v (q x + q x') (q y + q y') (q z + q z') in
  let rx = v (m.xx, l.xx) (m.xy, l.xy) (m.xz, l.xz)
  and ry = v (m.yx, l.yx) (m.yy, l.yy) (m.yz, l.yz)
  and rz = v (m.zx, l.zx) (m.zy, l.zy) (m.zz, l.zz)
  and shift = v (m.xt, l.xt) (m.yt, l.yt) (m.zt, l.zt) in
  let x = cross ry rz and y = cross rz rx and z = cross rx ry in
  let solve (a : vec) =
    scale
      (Q.inv (dot rx x))
      (add (scale a.x x) (add (scale a.y y) (scale a.z z)))
  in
  {
    Crossing.origin = solve (sub line.Crossing.origin shift);
    direction = solve line.direction;
  }

let step =
  let open Gen in
  oneof
    [
      map (fun v -> Transform.Translate v) (Draw.vec (Draw.uniform (-1.) 1.));
      (let* axis = Draw.unit and* degrees = Draw.uniform (-180.) 180. in
       return (Transform.Rotate { axis; degrees }));
      map (fun k -> Transform.Scale (Vec.v k k (-.k))) (Draw.uniform 0.9 1.1);
    ]

(* Twenty levels of three steps each: t is right within 2^-40 of the
   distance. *)
let nested_transforms (levels, (n, far)) =
  let transforms = List.map transform levels in
  let sphere = Made.sphere (Point.v 0.25 0.5 (-0.125)) 1.5 in
  let s =
    List.fold_left
      (fun s transform ->
        Surface.seen_through ~transform (Surface.group [| s |]))
      (Surface.sphere sphere 0) transforms
  in
  let center =
    List.fold_left
      (fun p t -> Affine.point (Transform.forward t).high p)
      (Sphere.center sphere) transforms
  in
  let o = Draw.move center n far in
  let ray =
    Ray.v o (Draw.toward o (Draw.move center (Vec.v 0.3 (-0.2) 0.1) 1.))
  in
  let line = List.fold_right exactly_back transforms (Crossing.line ray) in
  match
    ( Surface.nearest s ray,
      Crossing.first (Exact_sphere.truth sphere line).crossings )
  with
  | None, None -> true
  | Some h, Some c ->
      let t = Exact_root.approximate c.at in
      let off = Q.to_float (Q.abs (Q.sub (Exact.q h.t) t)) in
      off <= 0x1p-40 || Law.fail "t = %h is off by %h" h.t off
  | Some _, None -> Law.fail "a false hit"
  | None, Some _ -> Law.fail "a false miss"

(* {1 Rays that are none} *)

let no_rays { Family.shape; ray } =
  let s = Shapes.surface 0 shape and g = Shapes.group [| shape; shape |] in
  let bad = [ nan; infinity; neg_infinity ] in
  let odd x =
    let o = ray.origin and d = ray.direction in
    [
      Ray.v (Point.v x o.y o.z) d;
      Ray.v (Point.v o.x x o.z) d;
      Ray.v (Point.v o.x o.y x) d;
      Ray.v o (Vec.v x d.y d.z);
      Ray.v o (Vec.v d.x x d.z);
      Ray.v o (Vec.v d.x d.y x);
    ]
  in
  let still = Ray.v ray.origin (Vec.v 0. (-0.) 0.) in
  let misses s ray =
    Surface.nearest s ray = None && not (Surface.blocked s ~limit:infinity ray)
  in
  List.for_all
    (fun ray -> misses s ray && misses g ray)
    (still :: List.concat_map odd bad)
  && List.for_all
       (fun limit ->
         Surface.nearest s ~limit ray = None
         && not (Surface.blocked g ~limit ray))
       [ nan; 0.; -1.; neg_infinity ]

let empty_group () =
  let g : unit Surface.t = Surface.group [||] in
  let ray = Ray.v Point.origin (Vec.v 0. 0. 1.) in
  Alcotest.(check bool) "nearest" true (Surface.nearest g ray = None);
  Alcotest.(check bool) "blocked" false (Surface.blocked g ~limit:infinity ray)

(* {1 What a hit says} *)

let near_one x = Float.abs (x -. 1.) <= 0x1p-50

let hit_is_sound { Family.shape; ray } =
  match Surface.nearest (Shapes.surface 7 shape) ray with
  | None -> true
  | Some h ->
      let n = (h.normal :> Vec.t) and s = (h.shading_normal :> Vec.t) in
      let check what holds = holds || Law.fail "%s" what in
      check "t is not finite and positive" (h.t > 0. && h.t < infinity)
      && check "the normal is not unit" (near_one (Vec.norm n))
      && check "the point is not finite" (Point.is_finite h.point)
      && check "the path is not the place" (h.path = [ 0 ])
      && check "the material is lost" (h.material = 7)
      && check "the offset is negative" (h.offset >= 0.)
      && check "the shading normal is not the normal" (Vec.equal n s)
      && check "the error is negative"
           (h.local.error.x >= 0. && h.local.error.y >= 0.
          && h.local.error.z >= 0.)
      && check "the local normal is on the other side"
           (let outward = (h.local.normal :> Vec.t) in
            match h.side with
            | Outside -> Vec.equal n outward
            | Inside -> Vec.equal n (Vec.neg outward))

let law = Law.law
let scene_and g = Gen.pair Shapes.scene g

let suite =
  ( "nearest and blocked",
    [
      law ~count:2500 ~print:Shapes.show_scene
        "G8: a group is met like a linear scan of its members, ties to the \
         lowest place, and blocked where that finds something"
        Shapes.scene scan_agrees;
      law ~print:Shapes.show_scene
        "a group meets any of a kind where one of these alone is met"
        Shapes.scene asks_for_a_kind;
      law ~print:Shapes.show_scene "the path of a member is its place"
        Shapes.scene path_is_place;
      law ~count:2000
        ~print:(fun (s, _) -> Shapes.show_scene s)
        "G9: permuted surfaces give the same surface" (scene_and Gen.int_pos)
        permuted;
      law ~count:1000
        ~print:(fun (c, k) ->
          Printf.sprintf "%s\nk = %d" (Shapes.show_case c) k)
        "scaling by 2^k scales t, points and offsets by it, bit for bit"
        (Gen.pair Shapes.case (Gen.int_range (-60) 60))
        exactly_scaled;
      law ~count:1000
        ~print:(fun (c, k) ->
          Printf.sprintf "%s\nk = %d" (Shapes.show_case c) k)
        "a direction 2^k as long gives t 2^-k as large, bit for bit"
        (Gen.pair Shapes.case (Gen.int_range (-60) 60))
        direction_scaled;
      law ~count:1000
        ~print:(fun (c, k) ->
          Printf.sprintf "%s\naxis %d" (Shapes.show_case c) k)
        "mirroring an axis leaves t and mirrors point and normal"
        (Gen.pair no_ties (Gen.int_bound 2))
        mirrored;
      Law.example "a surface in 1,000 groups is met as if it stood alone" deep;
      law ~count:2500
        ~print:(fun (s, k) ->
          Printf.sprintf "%s\ncut at %d" (Shapes.show_scene s) k)
        "groups of groups are met like one group" (scene_and Gen.nat_small)
        split_anywhere;
      law
        ~print:(fun (s, _) -> Shapes.show_scene s)
        "nested translations that round nothing change nothing"
        (scene_and
           (Gen.list_size (Gen.int_range 1 20) (Draw.vec (Draw.small 9))))
        moved_by_whole_numbers;
      law ~count:100
        ~print:(fun (levels, (n, far)) ->
          Printf.sprintf "%s\nfrom %s at %h"
            (String.concat "\n"
               (List.map
                  (fun steps ->
                    String.concat "; " (List.map Transform.show_step steps))
                  levels))
            (Draw.show_vec n) far)
        "twenty nested transforms agree with the exact composition within 2^-40"
        Gen.(
          pair
            (list_size (return 20) (list_size (return 3) step))
            (pair Draw.unit (Draw.wide 0.5 1.)))
        nested_transforms;
      law ~print:Shapes.show_case "G7: what is no ray meets nothing" Shapes.case
        no_rays;
      Law.example "an empty group is never met" empty_group;
      law ~count:1000 ~print:Shapes.show_case
        "G26: a hit, if there is one, says what its documentation promises"
        Shapes.case hit_is_sound;
    ] )

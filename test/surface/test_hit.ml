open Candor_space
open Candor_surface
open Candor_oracle
open Candor_surface_families
open QCheck2

let u = 0x1p-53

(* {1 Leaving} *)

type leaving = {
  case : Shapes.t Family.case;
  toward : Vec.t;  (** where to go, from the side that was hit *)
}

let show { case; toward } =
  Printf.sprintf "%s\nleaving along %s" (Shapes.show_case case)
    (Draw.show_vec toward)

let directions =
  Gen.oneof
    [
      Draw.unit;
      Draw.axial;
      Gen.map Vec.neg Draw.unit;
      Gen.(Draw.unit >>= Draw.stretched);
      (* almost along some plane *)
      Gen.map
        (fun (d, e) -> Vec.add d (Vec.scale e (Vec.v 0.3 0.5 0.7)))
        (Gen.pair Draw.axial (Draw.signed (Draw.wide (-16.) (-1.))));
    ]

let leaving cases =
  Gen.map (fun (case, toward) -> { case; toward }) (Gen.pair cases directions)

let hit s ray = Surface.nearest s ray

(* [f h d] where the ray hits; [d] leaves to the side [side]. *)
let on_hit ~side { case = { shape; ray }; toward } f =
  let s = Shapes.surface 0 shape in
  match hit s ray with
  | None -> true
  | Some h ->
      let out = (h.local.normal :> Vec.t) in
      let goes_out = Vec.dot out toward > 0. in
      let d =
        match (side : Side.t) with
        | Outside -> if goes_out then toward else Vec.neg toward
        | Inside -> if goes_out then Vec.neg toward else toward
      in
      let slope = Vec.dot out d /. Vec.norm d in
      f s h d ~slope

let meets_nothing s ray =
  match hit s ray with
  | None -> true
  | Some h ->
      Law.fail "%s meets it again: part %d %s at t = %h" (Draw.show_ray ray)
        h.part (Side.show h.side) h.t

let convex = function
  | Shapes.Sphere _ | Box _ | Triangle _ -> true
  | Quadric q -> (
      match Quadric.shape q with
      | Plane _ | Ellipsoid _ -> Quadric.clip q = None
      | Cylinder _ | Cone _ | Paraboloid _ ->
          Quadric.caps q && Quadric.clip q = None
      | _ -> false)

(* A sphere no thicker than the rounding of its centre has no inside. *)
let closed = function
  | Shapes.Sphere s ->
      let { Point.x; y; z } = Sphere.center s in
      s.radius >= 0x1p-40 *. Vec.largest (Vec.v x y z)
  | Box b ->
      let b = (b :> Bounds.t) in
      b.x0 < b.x1 && b.y0 < b.y1 && b.z0 < b.z1
  | Triangle _ -> false
  | Quadric q -> (
      match Quadric.shape q with
      | Ellipsoid _ -> Quadric.clip q = None
      | Cylinder _ | Cone _ | Paraboloid _ ->
          Quadric.caps q && Quadric.clip q = None
      | _ -> false)

(* The point of a cone or the seam of two planes: there is no tangent plane to
   leave by. *)
let at_apex (h : _ Hit.t) = function
  | Shapes.Quadric q when h.part = 0 -> (
      let f = Form.of_shape (Quadric.shape q) in
      let center = Form.center f in
      let y = Vec.norm (Point.sub h.local.point center) in
      let slope = Form.gradient f (Point.sub h.local.point center) in
      Vec.norm slope <= 0x1p-20 *. ((f.a_size *. y) +. f.g_size)
      ||
      match Quadric.shape q with
      | Cone { apex; base; _ } ->
          let length = Vec.norm (Point.sub base apex) in
          y <= 0x1p-20 *. (length +. Vec.norm (Point.sub apex Point.origin))
      | _ -> false)
  | _ -> false

let outwards ({ case = { shape; _ }; _ } as l) =
  (not (convex shape))
  || on_hit ~side:Outside l (fun s h d ~slope ->
      slope = 0. || at_apex h shape || meets_nothing s (Hit.spawn h d))

let triangles_never ({ case = { shape; _ }; _ } as l) =
  match shape with
  | Triangle _ ->
      on_hit ~side:Inside l (fun s h d ~slope:_ ->
          meets_nothing s (Hit.spawn h d))
  | _ -> true

(* Where another part of the surface is so near that rounding cannot tell. *)
let near_rim (h : _ Hit.t) = function
  | Shapes.Sphere _ | Triangle _ -> false
  | Box b ->
      let b = (b :> Bounds.t) in
      let near x lo hi =
        let e = 0x1p-40 *. (Float.abs lo +. Float.abs hi +. Float.abs x) in
        Float.abs (x -. lo) < e || Float.abs (x -. hi) < e
      in
      let p = h.local.point in
      let edges =
        [ near p.x b.x0 b.x1; near p.y b.y0 b.y1; near p.z b.z0 b.z1 ]
      in
      List.length (List.filter Fun.id edges) > 1
  | Quadric q -> (
      match Quadrics.ends (Quadric.shape q) with
      | None -> false
      | Some (a, b, r) ->
          let axis = Point.sub b a in
          let l2 = Vec.dot axis axis in
          let p = Point.sub h.local.point a in
          let k = Vec.dot p axis /. l2 in
          let size = Vec.norm p +. Vec.norm (Point.sub a Point.origin) in
          let e = 0x1p-30 *. (1. +. (size /. sqrt l2)) in
          let radial = Vec.norm (Vec.sub p (Vec.scale k axis)) in
          let rim end_ =
            Float.abs (k -. end_) < e
            && (h.part = 0 || Float.abs (radial -. r) < 0x1p-30 *. (r +. size))
          in
          rim 0. || rim 1.)

let inwards ({ case = { shape; _ }; _ } as l) =
  (not (closed shape))
  || on_hit ~side:Inside l (fun s h d ~slope ->
      let grazes = slope > -0x1p-20 in
      if grazes || at_apex h shape || near_rim h shape then true
      else
        match hit s (Hit.spawn h d) with
        | None -> Law.fail "%s never leaves" (Draw.show_ray (Hit.spawn h d))
        | Some h' ->
            at_apex h' shape || near_rim h' shape
            || (h'.side = Inside && meets_nothing s (Hit.spawn h' d)))

(* {1 The new origin} *)

(* > 0 outside, < 0 inside, of the part that was hit. *)
let exact_value (h : _ Hit.t) p = function
  | Shapes.Sphere s -> Exact_sphere.value s p
  | Triangle s -> Exact_triangle.value s p
  | Box b ->
      let b = (b :> Bounds.t) in
      let q = Exact.q in
      [|
        Q.sub (q b.x0) p.x;
        Q.sub p.x (q b.x1);
        Q.sub (q b.y0) p.y;
        Q.sub p.y (q b.y1);
        Q.sub (q b.z0) p.z;
        Q.sub p.z (q b.z1);
      |].(h.part)
  | Quadric q when h.part = 0 -> Exact_quadric.(value (of_quadric q).form p)
  | Quadric q ->
      let cut =
        List.find
          (fun (c : Exact_quadric.cut) -> c.cap = Some h.part)
          (Exact_quadric.of_quadric q).cuts
      in
      Exact_quadric.beyond cut p

let origin_is_beside side ({ case = { shape; _ }; _ } as l) =
  on_hit ~side l (fun _ h d ~slope ->
      slope = 0. || at_apex h shape
      ||
      let o = (Hit.spawn h d).origin in
      let s = Q.sign (exact_value h (Exact.point o) shape) in
      let s = match side with Side.Outside -> s | Inside -> -s in
      s >= 0
      || Law.fail "the origin %s is on the wrong side" (Draw.show_point o))

let norm1 (p : Point.t) = Float.abs p.x +. Float.abs p.y +. Float.abs p.z

(* How large the numbers are that the surface is made of. *)
let extent = function
  | Shapes.Sphere s -> norm1 (Sphere.center s) +. s.radius
  | Box b ->
      let b = (b :> Bounds.t) in
      norm1 (Bounds.low b) +. norm1 (Bounds.high b)
  | Triangle { corners = { a; b; c }; _ } -> norm1 a +. norm1 b +. norm1 c
  | Quadric q -> (
      match Quadric.shape q with
      | Ellipsoid { center; radii } -> norm1 center +. Vec.largest radii
      | Cylinder { from = a; until = b; radius = r }
      | Cone { apex = a; base = b; radius = r }
      | Paraboloid { apex = a; base = b; radius = r } ->
          norm1 a +. norm1 b +. r
      | _ -> 1.)

let offset_is_small ({ case = { shape; _ }; _ } as l) =
  on_hit ~side:Outside l (fun _ h _ ~slope:_ ->
      at_apex h shape
      ||
      let size = norm1 h.point +. extent shape in
      h.offset <= 8. *. u *. size
      || Law.fail "the offset %h is %g u of the coordinates" h.offset
           (h.offset /. (u *. size)))

(* The point is the ray at t, up to the rounding of the ray. *)
let point_is_on_ray { Family.shape; ray } =
  match hit (Shapes.surface 0 shape) ray with
  | None -> true
  | Some h ->
      let along = Ray.at ray h.t in
      let off = Vec.norm (Point.sub along h.point) in
      let reach = norm1 ray.origin +. norm1 along +. extent shape in
      off <= 0x1p-30 *. reach
      || Law.fail "%s is %g of %g from the ray at t" (Draw.show_point h.point)
           off reach

(* Another copy in the same place stands for whatever touches the surface. *)
let leaves_its_twin side ({ case = { shape; _ }; _ } as l) =
  (not (convex shape))
  || on_hit ~side l (fun _ h d ~slope ->
      let two =
        Surface.group [| Shapes.surface 0 shape; Shapes.surface 1 shape |]
      in
      if Float.abs slope < 0x1p-20 || at_apex h shape || near_rim h shape then
        true
      else
        let ray = Hit.spawn h d in
        match (hit two ray, side) with
        | None, Side.Outside -> true
        | None, Inside -> not (closed shape)
        | Some h', Outside ->
            Law.fail "it meets its twin at t = %h from %s" h'.t
              (Draw.show_ray ray)
        | Some h', Inside ->
            h'.side = Inside || at_apex h' shape
            || Law.fail "it enters its twin at t = %h from %s" h'.t
                 (Draw.show_ray ray))

(* {1 The other root} *)

(* With the root at 0 taken out, the other one is at -2h/a. *)
let other_root ({ case = { shape; _ }; _ } as l) =
  let rest ray (h : _ Hit.t) =
    let line = Crossing.line ray in
    match shape with
    | Shapes.Sphere s when h.part = 0 ->
        let a, b, _ = Exact_sphere.equation s line in
        Some (a, b)
    | Quadric q
      when h.part = 0
           && (not (Quadric.caps q))
           && Quadric.clip q = None
           && Quadrics.ends (Quadric.shape q) = None ->
        let a, b, _ = Exact_quadric.(equation (of_quadric q).form line) in
        Some (a, b)
    | _ -> None
  in
  let check side =
    on_hit ~side l (fun s h d ~slope:_ ->
        let ray = Hit.spawn h d in
        match rest ray h with
        | None -> true
        | Some (a, b) -> (
            let t =
              if Q.sign a = 0 then Q.zero else Exact.(Q.neg (two * b) / a)
            in
            let falls = Q.sign b < 0 in
            let leaves_side = falls = (side = Side.Inside) && Q.sign b <> 0 in
            match hit s ray with
            | None ->
                Q.sign t <= 0
                || (not leaves_side)
                || Law.fail "the other root %h of %s is lost" (Q.to_float t)
                     (Draw.show_ray ray)
            | Some h' ->
                leaves_side
                && (Exact.within 5. h'.t t
                   || Law.fail "t = %h of %s should be %h" h'.t
                        (Draw.show_ray ray) (Q.to_float t))))
  in
  check Outside && check Inside

let spawned_scaling ({ case = { shape; _ }; _ }, k, l) =
  ignore shape;
  on_hit ~side:Inside l (fun s h d ~slope:_ ->
      let by = Float.ldexp 1. k in
      let t d = Option.map (fun (h : _ Hit.t) -> h.t) (hit s (Hit.spawn h d)) in
      match (t d, t (Vec.scale by d)) with
      | Some a, Some b -> a = b *. by || Law.fail "t = %h became %h" a b
      | None, None -> true
      | a, b ->
          let show = Option.fold ~none:"nothing" ~some:(Printf.sprintf "%h") in
          Law.fail "%s became %s" (show a) (show b))

(* {1 Instances} *)

let steps =
  let open Gen in
  let number = Draw.wide (-3.) 3. in
  list_size (int_range 1 4)
    (oneof
       [
         map
           (fun v -> Transform.Translate v)
           (Draw.vec (Draw.signed (Draw.wide (-2.) 6.)));
         (let* axis = Draw.unit and* degrees = Draw.uniform (-180.) 180. in
          return (Transform.Rotate { axis; degrees }));
         map (fun k -> Transform.Scale (Vec.v k k k)) (Draw.wide (-8.) 8.);
         map (fun v -> Transform.Scale v) (Draw.vec (Draw.signed number));
       ])

let instanced (l, steps) =
  let { case = { shape; ray }; toward } = l in
  match Transform.of_steps steps with
  | Error _ -> true
  | Ok transform -> (
      let m = (Transform.forward transform).high in
      let s =
        Surface.seen_through ~transform
          (Surface.group [| Shapes.surface 0 shape |])
      in
      let ray =
        Ray.v (Affine.point m ray.origin) (Affine.vector m ray.direction)
      in
      (not (convex shape))
      ||
      match hit s ray with
      | None -> true
      | Some h ->
          let n = (h.normal :> Vec.t) in
          let leaves_outside = h.side = Outside in
          let d =
            if Vec.dot n toward > 0. = leaves_outside then toward
            else Vec.neg toward
          in
          Float.abs (Vec.dot n d) <= 0x1p-20 *. Vec.norm d
          || at_apex h shape || near_rim h shape
          || meets_nothing s (Hit.spawn h d))

let scaled_cases =
  let open Gen in
  let* { Family.shape; ray } = Shapes.case and* k = int_range (-20) 30 in
  let c = Shapes.scaling k in
  match Shapes.change c shape with
  | Some shape -> return { Family.shape; ray = Shapes.change_ray c ray }
  | None -> return { Family.shape; ray }

let cases = leaving scaled_cases

let law ?(count = 5000) name gen holds =
  Law.law ~count ~print:show name gen holds

let suite =
  ( "hits and what leaves them",
    [
      law "a ray that leaves a convex surface outwards meets nothing" cases
        outwards;
      law "a ray that leaves a triangle never meets it" cases triangles_never;
      law "a ray that leaves a closed surface inwards meets it once more" cases
        inwards;
      law "leaving outwards starts outside of the exact surface" cases
        (origin_is_beside Outside);
      law "leaving inwards starts inside of the exact surface" cases
        (origin_is_beside Inside);
      law "the offset is at most 8 u of the coordinates" cases offset_is_small;
      Law.law ~count:5000 ~print:Shapes.show_case
        "the point of a hit is on the ray" Shapes.case point_is_on_ray;
      law "leaving outwards meets no twin in the same place" cases
        (leaves_its_twin Outside);
      law "leaving inwards does not enter a twin in the same place" cases
        (leaves_its_twin Inside);
      law "the root left behind is taken out exactly" cases other_root;
      Law.law ~count:5000
        ~print:(fun (l, k, _) -> Printf.sprintf "%s\nk = %d" (show l) k)
        "leaving along 2^k d gives t 2^-k as large"
        Gen.(map2 (fun l k -> (l, k, l)) cases (int_range (-200) 200))
        spawned_scaling;
      Law.law ~count:5000
        ~print:(fun (l, steps) ->
          Printf.sprintf "%s\nthrough %s" (show l)
            (String.concat "; " (List.map Transform.show_step steps)))
        "G4: a ray that leaves an instance outwards meets nothing"
        (Gen.pair cases steps) instanced;
    ] )

open Candor_space
open Candor_surface
open Candor_oracle
open Candor_surface_families

let p = Point.v
let v = Vec.v

(* {1 Rows of the catalogue} *)

let meets name s ray expected () =
  match (Triangles.kind.answer s ray, expected) with
  | None, None -> ()
  | Some a, Some t when Exact.within 2. a.t (Exact.q t) -> ()
  | found, _ ->
      Alcotest.failf "%s: expected %s, found %s" name
        (Option.fold ~none:"no hit" ~some:string_of_float expected)
        (Family.show_answer found)

let half = Made.triangle (p 0. 0. 0.) (p 1. 0. 0.) (p 0. 1. 0.)

let rows =
  [
    ( "T4: a triangle 1e-5 wide",
      Made.triangle (p (-1e-5) (-1e-5) 0.) (p 1e-5 (-1e-5) 0.) (p 0. 1e-5 0.),
      Ray.v (p 0. 0. 1.) (v 0. 0. (-1.)),
      Some 1. );
    ( "T6: a skinny triangle half a degree from the ray",
      Made.triangle (p 0. 0. 0.) (p 11.2 0. 0.) (p 9.6 1.4 0.),
      Ray.v (p (-500.) 3. 5.) (v 1. 0. (-0.0091)),
      None );
    ( "T7: a needle that pbrt once met",
      Made.triangle
        (p (-1113.45459) (-79.049614) (-56.2431908))
        (p (-1113.45459) (-87.0922699) (-56.2431908))
        (p (-1113.45459) (-79.2090149) (-56.2431907)),
      Ray.v
        (p (-1081.47925) 99.9999542 87.7701111)
        (v (-32.1072998) (-183.355865) (-144.607635)),
      None );
    ( "T11: in its plane, across",
      half,
      Ray.v (p (-1.) 0.25 0.) (v 1. 0. 0.),
      None );
    ( "T11: in its plane, along an edge",
      half,
      Ray.v (p (-1.) 0. 0.) (v 1. 0. 0.),
      None );
    ("T11: beside its plane", half, Ray.v (p (-1.) 0.25 1.) (v 1. 0. 0.), None);
    ("T12: from on it", half, Ray.v (p 0.25 0.25 0.) (v 0. 0. 1.), None);
    ("T12: from a corner of it", half, Ray.v (p 0. 0. 0.) (v 1. 1. 1.), None);
    ("T12: from an edge of it", half, Ray.v (p 0.5 0. 0.) (v 0. 1. (-1.)), None);
    ( "T12: from beneath it",
      half,
      Ray.v (p 0.25 0.25 (-5e-324)) (v 0. 0. 1.),
      Some 5e-324 );
  ]

let rejected =
  let reject name a b c =
    Law.example (name ^ " is rejected") (fun () ->
        match Triangle.make { a; b; c } with
        | Error why when why <> "" -> ()
        | _ -> Alcotest.failf "%s is accepted" name)
  in
  [
    reject "T9: a repeated corner" (p 1. 2. 3.) (p 1. 2. 3.) (p 0. 0. 1.);
    reject "T9: corners on one line" (p 0. 0. 0.) (p 1. 2. 3.) (p 3. 6. 9.);
    reject "T9: corners on one far line" (p 1e6 0. 0.) (p 1e6 1. 1.)
      (p 1e6 7. 7.);
    reject "a corner that is not a number" (p 0. nan 0.) (p 1. 0. 0.)
      (p 0. 1. 0.);
    reject "an infinite corner" (p 0. 0. 0.) (p infinity 0. 0.) (p 0. 1. 0.);
    reject "a corner beyond 2^400" (p 0. 0. 0.) (p 0x1.8p400 0. 0.) (p 0. 1. 0.);
    Law.example "a zero normal is rejected" (fun () ->
        let n = v 0. 0. 1. in
        match Triangle.make ~normals:(n, Vec.zero, n) half.corners with
        | Error why when why <> "" -> ()
        | _ -> Alcotest.fail "it is accepted");
  ]

(* Areas of a single rounding are seen. *)
let thinnest () =
  List.iter
    (fun (a, b, c) ->
      Alcotest.(check bool)
        "made" true
        (Result.is_ok (Triangle.make { a; b; c })))
    [
      (p 0. 0. 0., p 1. 1. 1., p 3. 3. (Float.succ 3.));
      (p 0. 0. 0., p 0.1 0.1 0.1, p 0.3 0.3 (Float.succ 0.3));
      ( p 1e9 1e9 0.,
        p (1e9 +. 1.) (1e9 +. 1.) 0.,
        p (1e9 +. 2.) (Float.succ (1e9 +. 2.)) 0. );
      (p 0. 0. 0., p 1. 0. 0., p 0. 5e-324 0.);
      (p 0x1p-400 0. 0., p 0. 0x1p-400 0., p 0. 0. 0x1p-400);
      (p 0x1p400 0. 0., p 0. 0x1p400 0., p 0. 0. 0x1p400);
    ]

(* {1 What a hit says} *)

let found { Family.shape; ray } f =
  match Surface.nearest (Surface.triangle shape ()) ray with
  | None -> true
  | Some h -> f shape ray h

(* The point is in the plane within its error, and within the bounds. *)
let in_plane (s : Triangle.t) _ (h : unit Hit.t) =
  let n = Exact_triangle.normal s in
  let abs (a : Exact.vec) = Exact.v (Q.abs a.x) (Q.abs a.y) (Q.abs a.z) in
  Q.leq
    (Q.abs (Exact_triangle.value s (Exact.point h.point)))
    (Exact.dot (abs n) (Exact.vec h.local.error))
  && Bounds.mem h.point (Bounds.widen 0. (Triangle.bounds s))

let right_normal (s : Triangle.t) _ (h : unit Hit.t) =
  let n = Exact_triangle.normal s in
  let found = Exact.vec (h.local.normal :> Vec.t) in
  let off = Exact.cross n found in
  Q.sign (Exact.dot n found) > 0
  && Q.leq (Exact.dot off off) Exact.(power (-60) * dot n n)

let faces_ray (s : Triangle.t) (ray : Ray.t) (h : unit Hit.t) =
  let n = Exact_triangle.normal s in
  let across = Q.sign (Exact.dot n (Exact.vec ray.direction)) in
  across = match h.side with Outside -> -1 | Inside -> 1

let barycentric (s : Triangle.t) _ (h : unit Hit.t) =
  let { Triangle.a; b; c } = s.corners in
  match Lazy.force h.local.uv with
  | None -> false
  | Some (u, v) ->
      let w = 1. -. u -. v in
      let mix f = (w *. f a) +. (u *. f b) +. (v *. f c) in
      let close f x =
        Float.abs (mix f -. x)
        <= 0x1p-49 *. (Float.abs (f a) +. Float.abs (f b) +. Float.abs (f c))
      in
      u >= 0. && v >= 0. && u <= 1. && v <= 1.
      && close (fun (q : Point.t) -> q.x) h.point.x
      && close (fun q -> q.y) h.point.y
      && close (fun q -> q.z) h.point.z

(* The weights, from the exact point of the line. *)
let exact_weights (s : Triangle.t) (ray : Ray.t) (h : unit Hit.t) =
  let a, b, c = Exact_triangle.corners s in
  let { Crossing.origin = o; direction = d } = Crossing.line ray in
  let open Exact in
  let a = sub a o and b = sub b o and c = sub c o in
  let ea = dot d (cross b c) and eb = dot d (cross c a) in
  let ec = dot d (cross a b) in
  let sum = ea + eb + ec in
  let far = size a + size b + size c in
  let thick = largest (sub b a) + largest (sub c a) in
  (* Off by the rounding of the way there, seen from the triangle. *)
  let bound = power (-33) * far / thick in
  match Lazy.force h.local.uv with
  | None -> false
  | Some (u, v) ->
      Q.leq (Q.abs (q u - (eb / sum))) bound
      && Q.leq (Q.abs (q v - (ec / sum))) bound

let own_uv () =
  let uv =
    { Triangle.ua = 10.; va = 20.; ub = 30.; vb = 40.; uc = 50.; vc = 60. }
  in
  match Triangle.make ~uv half.corners with
  | Error why -> Alcotest.fail why
  | Ok s -> (
      let ray = Ray.v (p 0.25 0.5 1.) (v 0. 0. (-1.)) in
      match Surface.nearest (Surface.triangle s ()) ray with
      | None -> Alcotest.fail "missed"
      | Some h ->
          Alcotest.(check (option (pair (float 0.) (float 0.))))
            "uv"
            (Some (35., 45.))
            (Lazy.force h.local.uv))

let smooth () =
  let n x = v x 0. 1. in
  match Triangle.make ~normals:(n 0., n 1., n (-1.)) half.corners with
  | Error why -> Alcotest.fail why
  | Ok s ->
      let check z direction =
        let ray = Ray.v (p 0.5 0.25 z) direction in
        match Surface.nearest (Surface.triangle s ()) ray with
        | None -> Alcotest.fail "missed"
        | Some h ->
            let n = (h.shading_normal :> Vec.t) in
            Alcotest.(check bool)
              "unit" true
              (Float.abs (Vec.norm n -. 1.) < 1e-15);
            Alcotest.(check bool) "leans to b" true (n.x *. n.z > 0.);
            Alcotest.(check bool)
              "on the side the ray came from" true
              (Vec.dot n direction < 0.)
      in
      check 1. (v 0. 0. (-1.));
      check (-1.) (v 0. 0. 1.)

(* {1 At the edges of a convex mesh} *)

(* An octahedron about the origin, of any shape and stance. *)
let octahedron =
  let open QCheck2.Gen in
  let* n = Draw.unit and* degrees = Draw.uniform 0. 360. in
  let* size = Draw.wide (-6.) 6. and* sizes = Draw.vec (Draw.uniform 0.5 2.) in
  let turn = Transform.of_steps [ Rotate { axis = n; degrees } ] in
  let m = (Transform.forward (Made.get "turn" turn)).high in
  let tip axis sign =
    let along k = if k = axis then sign *. size *. Vec.get sizes k else 0. in
    Affine.point m (p (along 0) (along 1) (along 2))
  in
  let face x y z =
    let a = tip 0 x and b = tip 1 y and c = tip 2 z in
    if x *. y *. z > 0. then Made.triangle a b c else Made.triangle a c b
  in
  let signs = [ 1.; -1. ] in
  let faces =
    List.concat_map
      (fun x -> List.concat_map (fun y -> List.map (face x y) signs) signs)
      signs
  in
  return (Array.of_list faces)

let at_edges =
  let open QCheck2.Gen in
  let* faces = octahedron
  and* k = int_bound 7
  and* share = Draw.uniform 0. 1. in
  let { Triangle.a; b; c } = faces.(k).corners in
  let* target = Draw.pick [ a; b; c; Triangles.middle a b share ] in
  let* d = Draw.unit and* far = Draw.pick [ 2.; 10.; 1000. ] in
  let size = Vec.largest (Point.sub target Point.origin) in
  let o = Draw.move target d (far *. size) in
  return (faces, Ray.v o (Draw.toward o target))

let show_mesh (faces, ray) =
  String.concat "\n" (Array.to_list (Array.map Triangles.show faces))
  ^ "\n" ^ Draw.show_ray ray

(* Strictly inside of every other face. *)
let inside_of_neighbours (faces, ray) =
  match
    Surface.nearest
      (Surface.group (Array.map (fun s -> Surface.triangle s ()) faces))
      ray
  with
  | None -> true
  | Some h ->
      let inside s =
        Q.sign (Exact_triangle.value s (Exact.point h.point)) < 0
      in
      let others =
        List.filteri (fun i _ -> [ i ] <> h.path) (Array.to_list faces)
      in
      List.for_all inside others

let kinds = Triangles.[ ordinary; t5; needles; far_away ]

let each name f =
  List.map
    (fun { Family.name = family; cases } ->
      Law.law ~count:1500
        ~print:(Family.show Triangles.kind)
        (name ^ ": " ^ family)
        cases
        (fun c -> found c f))
    kinds

let suite =
  ( "triangle",
    List.concat
      [
        List.map
          (fun (name, s, ray, expected) ->
            Law.example name (meets name s ray expected))
          rows;
        [
          Law.example "the thinnest triangles have area" thinnest;
          Law.example "uv are interpolated" own_uv;
          Law.example "normals are interpolated, on the side of the ray" smooth;
          Law.law ~count:5000 ~print:show_mesh
            "hits at edges and corners of a convex mesh are a hair inside of \
             its other faces"
            at_edges inside_of_neighbours;
        ];
        each "points are in the plane within their error" in_plane;
        each "the normal is right within 2^-30" right_normal;
        each "the side is where the ray comes from" faces_ray;
        each "uv are the weights of the point" barycentric;
        each "the weights are those of the line" exact_weights;
        rejected;
      ] )

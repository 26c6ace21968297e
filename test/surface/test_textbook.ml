open Candor_space
open Candor_surface
open Candor_oracle
open Candor_surface_families
open QCheck2

let p = Point.v
let v = Vec.v
let textbook s = Surface.group ~math:Textbook [| s |]

(* {1 Ordinary cases}

   Where nothing is near a tie: what is met, and how it leans, hardly changes if
   the ray is moved a little to any side, and it is not met at a small angle. *)

let about = 1e-3

let moved (ray : Ray.t) =
  let by x y z = Ray.v (Point.add ray.origin (v x y z)) ray.direction in
  List.concat_map
    (fun e -> [ by e 0. 0.; by 0. e 0.; by 0. 0. e ])
    [ about; -.about ]

let alike (a : _ Hit.t) (b : _ Hit.t) =
  let bend = Vec.sub (a.normal :> Vec.t) (b.normal :> Vec.t) in
  a.side = b.side && a.part = b.part && Vec.largest bend < 20. *. about

let steep (ray : Ray.t) = function
  | None -> true
  | Some (h : _ Hit.t) ->
      let cosine = Vec.dot (h.normal :> Vec.t) ray.direction in
      Float.abs cosine > 0.1 *. Vec.norm ray.direction && h.t > 2. *. about

let is_settled s ray =
  let found = Surface.nearest s ray in
  let same r = Option.equal alike (Surface.nearest s r) found in
  steep ray found && List.for_all same (moved ray)

let step =
  let open Gen in
  oneof
    [
      map (fun v -> Transform.Translate v) (Draw.vec (Draw.uniform (-3.) 3.));
      (let* axis = Draw.unit and* degrees = Draw.uniform (-180.) 180. in
       return (Transform.Rotate { axis; degrees }));
      map
        (fun v -> Transform.Scale v)
        (Draw.vec (Draw.signed (Draw.uniform 0.5 2.)));
    ]

type case = { shape : Shapes.t; steps : Transform.step list; ray : Ray.t }

let show_steps steps =
  "through " ^ String.concat "; " (List.map Transform.show_step steps)

let show { shape; steps; ray } =
  Shapes.show_case { shape; ray } ^ "\n" ^ show_steps steps

let transform steps = Made.get "transform" (Transform.of_steps steps)

let within { shape; steps; _ } math =
  Surface.seen_through ~transform:(transform steps)
    (Surface.group ~math [| Shapes.surface 7 shape |])

(* Along the axis of a paraboloid and the like, next to nothing is left of the
   square in a quadric's equation. *)
let bends { shape; steps; ray } =
  match shape with
  | Shapes.Quadric q ->
      let back = (Transform.backward (transform steps)).high in
      let d = Affine.vector back ray.direction in
      let f = Form.of_shape (Quadric.shape q) in
      Float.abs (Form.bend f d Vec.zero).hi > 1e-3 *. f.a_size *. Vec.dot d d
  | Sphere _ | Box _ | Triangle _ -> true

let is_ordinary case = bends case && is_settled (within case Stable) case.ray

(* From afar or from within, through the middle or beside it. *)
let rec ordinary kind steps =
  let open Gen in
  let center = p 0.5 (-1.) 0.25 in
  let* shape = Shapes.about center 2. and* steps = steps in
  (* Not in line with the centre, where the points of cones are. *)
  let beside = Point.add center (v 0.07 (-0.13) 0.06) in
  let near far = map (fun d -> Draw.move beside d far) Draw.unit in
  let* o = oneof [ near 0.2; near 12. ] and* target = near 0.8 in
  let through m p = Affine.point (Transform.forward m).high p in
  let o = through (transform steps) o
  and target = through (transform steps) target in
  let case = { shape; steps; ray = Ray.v o (Draw.toward o target) } in
  if kind shape && is_ordinary case then return case
  else ordinary kind (return steps)

let close a b = Float.abs (a -. b) <= 1e-9 *. Float.max 1. (Float.abs b)

let close_vec (a : Vec.t) (b : Vec.t) =
  close a.x b.x && close a.y b.y && close a.z b.z

(* Where they have neither seams nor poles. *)
let close_uv a b =
  match (Lazy.force a, Lazy.force b) with
  | None, None -> true
  | Some (u, v), Some (u', v') -> close u u' && close v v'
  | None, Some _ | Some _, None -> false

let place (p : Point.t) = Point.sub p Point.origin

let agrees case =
  let ask math = Surface.nearest (within case math) case.ray in
  match (ask Stable, ask Textbook) with
  | None, None -> true
  | Some a, Some b ->
      let check what holds = holds || Law.fail "another %s" what in
      check "t" (Float.abs (a.t -. b.t) <= 1e-9 *. a.t)
      && check "side" (a.side = b.side)
      && check "part" (a.part = b.part)
      && check "point" (close_vec (place a.point) (place b.point))
      && check "normal" (close_vec (a.normal :> Vec.t) (b.normal :> Vec.t))
      && check "uv" ((not b.local.flat) || close_uv a.local.uv b.local.uv)
      && check "flat" (a.local.flat = b.local.flat)
      && check "path" (a.path = b.path)
      && check "material" (a.material = b.material)
      && check "offset" (b.offset = 0.)
  | Some _, None -> Law.fail "it is missed"
  | None, Some _ -> Law.fail "it is met"

let is_sphere = function
  | Shapes.Sphere _ -> true
  | Box _ | Triangle _ | Quadric _ -> false

let is_box = function
  | Shapes.Box _ -> true
  | Sphere _ | Triangle _ | Quadric _ -> false

let is_triangle = function
  | Shapes.Triangle _ -> true
  | Sphere _ | Box _ | Quadric _ -> false

let is_quadric = function
  | Shapes.Quadric _ -> true
  | Sphere _ | Box _ | Triangle _ -> false

let anything _ = true
let no_steps = Gen.return []
let some_steps = Gen.(list_size (int_range 1 3) step)

let ordinarily what kind steps =
  Law.law ~count:1000 ~print:show
    ("an ordinary " ^ what ^ " is met like by Candor, to 1e-9")
    (ordinary kind steps) agrees

(* {1 Its epsilon} *)

let tops =
  [
    Surface.sphere (Made.sphere (p 0. 0. (-1.)) 1.) ();
    Surface.box (Made.box (p (-1.) (-1.) (-2.)) (p 1. 1. 0.)) ();
    Surface.triangle
      (Made.triangle (p (-1.) (-1.) 0.) (p 1. (-1.) 0.) (p 0. 1. 0.))
      ();
    Surface.quadric
      (Made.quadric (Plane { normal = v 0. 0. 1.; offset = 0. }))
      ();
    Surface.seen_through
      ~transform:(transform [ Scale (v 1000. 1000. 1000.) ])
      (textbook (Surface.sphere (Made.sphere (p 0. 0. (-1.)) 1.) ()));
  ]

(* Down on what lies at z = 0, from [height] above it. *)
let met_at_top s height length =
  let ray = Ray.v (p 0. 0. height) (v 0. 0. (-.length)) in
  match Surface.nearest (textbook s) ray with
  | None -> false
  | Some h -> close (h.t *. length) height

let epsilon length =
  Textbook.epsilon = 1e-4
  && List.for_all
       (fun s ->
         met_at_top s 1.01e-4 length && not (met_at_top s 0.99e-4 length))
       tops

(* {1 What breaks} *)

(* The kernels themselves: boxes around surfaces would hide some false hits. *)
let by_textbook s o d =
  match s with
  | Shapes.Sphere s -> Textbook.sphere s o d
  | Box b -> Textbook.box b o d
  | Triangle s -> Textbook.triangle s o d
  | Quadric q -> Textbook.quadric q o d

let by_candor s o d =
  let ray = Object_ray.v o d in
  match s with
  | Shapes.Sphere s -> Sphere.meet s ray Contact.none
  | Box b -> Box.meet b ray Contact.none
  | Triangle s -> Triangle.meet s ray Contact.none
  | Quadric q -> Quadric.meet q ray Contact.none

let time ?least meet =
  let cursor = Cursor.v ?least infinity in
  if Contact.is_none (meet cursor) then None else Some cursor.t

let to_13_digits =
  let equal a b = Float.abs (a -. b) <= 1e-13 *. b in
  Alcotest.testable (Fmt.of_to_string (Printf.sprintf "%.17g")) equal

let breaks name shape (o, d) (naive, right) =
  Law.example name (fun () ->
      let check = Alcotest.(check (option to_13_digits)) in
      let least = Textbook.epsilon /. Vec.norm d in
      check "the textbook's t" naive (time ~least (by_textbook shape o d));
      check "Candor's t" right (time (by_candor shape o d)))

let sphere c r = Shapes.Sphere (Made.sphere c r)
let form x y z b = Shapes.Quadric (Made.quadric (Quadrics.form x y z b 0.))

let failures =
  [
    breaks "S1: from 1e9 away it is wrong by a radius" (sphere Point.origin 1.)
      (p 0. 0. (-1e9), v 0. 0. 1.)
      (Some 1e9, Some 999999999.);
    breaks "S2: just past a sphere it meets it" (sphere Point.origin 1.)
      (p (-1e8) (1. +. 1e-9) 0., v 1. 0. 0.)
      (Some 1e8, None);
    breaks "S6: past a tiny sphere it meets it" (sphere Point.origin 1e-9)
      (p 0. 2e-9 (-1.), v 0. 0. 1.)
      (Some 1., None);
    breaks "B1: along a face of a box 0 times infinity makes it miss"
      (Box (Made.box Point.origin (p 1. 1. 1.)))
      (p 0. 0.5 (-1.), v 0. 0. 1.)
      (None, Some 1.);
    breaks "T4: it misses a triangle 1e-5 wide"
      (Triangle
         (Made.triangle (p (-1e-5) (-1e-5) 0.) (p 1e-5 (-1e-5) 0.)
            (p 0. 1e-5 0.)))
      (p 0. 0. 1., v 0. 0. (-1.))
      (None, Some 1.);
    breaks "Q1: along a generator of a cone it misses"
      (form 1. 1. (-1.) Vec.zero)
      (p 0. 0. 2., v (cos 1.) (sin 1.) 1.)
      (None, Some 8.2547808514653e16);
    breaks "Q3: almost along the axis of a paraboloid it misses"
      (form 1. 1. 0. (v 0. 0. 0.5))
      (p 0.5 0.25 9., v 1e-9 0. (-1.))
      (None, Some 8.6874999913125);
  ]

(* Through one of two spheres that are nearer to each other than epsilon, on to
   the other. *)
let gap () =
  let ball r = Surface.sphere (Made.sphere Point.origin r) () in
  let spheres = [| ball (1. +. 4e-5); ball 1. |] in
  let second math =
    let s = Surface.group ~math spheres in
    let down = v 0. 0. (-1.) in
    match Surface.nearest s (Ray.v (p 0. 0. 5.) down) with
    | None -> Alcotest.fail "missed"
    | Some h ->
        Option.map
          (fun (h : _ Hit.t) -> (h.path, h.side = Outside))
          (Surface.nearest s (Hit.spawn h down))
  in
  let check = Alcotest.(check (option (pair (list int) bool))) in
  check "Candor enters the inner one" (Some ([ 1 ], true)) (second Stable);
  check "the textbook finds itself within it"
    (Some ([ 1 ], false))
    (second Textbook)

(* {1 What leaves a hit, and groups} *)

let leaves_from_itself (case, d) =
  match Surface.nearest (within case Textbook) case.ray with
  | None -> true
  | Some h -> Point.equal (Hit.spawn h d).origin h.point

let plain_inverse (steps, (ray : Ray.t)) =
  let m = transform steps in
  let back = (Transform.backward m).high in
  let inside = Textbook.group m (Object_ray.of_ray ray) in
  inside.exact
  && Point.equal inside.origin (Affine.point back ray.origin)
  && Vec.equal inside.direction (Affine.vector back ray.direction)

let suite =
  ( "textbook",
    List.concat
      [
        [
          ordinarily "sphere" is_sphere no_steps;
          ordinarily "box" is_box no_steps;
          ordinarily "triangle" is_triangle no_steps;
          ordinarily "quadric" is_quadric no_steps;
          ordinarily "surface in a group" anything some_steps;
          Law.law ~count:500 ~print:(Printf.sprintf "%h")
            "nothing nearer than epsilon is met, however long the direction"
            (Draw.wide (-2.) 3.) epsilon;
        ];
        failures;
        [
          Law.example "S20: gaps below epsilon are not seen" gap;
          Law.law
            ~print:(fun (c, d) -> show c ^ "\nthen along " ^ Draw.show_vec d)
            "rays leave from the point itself"
            Gen.(pair (ordinary anything some_steps) Draw.unit)
            leaves_from_itself;
          Law.law
            ~print:(fun (steps, ray) ->
              show_steps steps ^ "\n" ^ Draw.show_ray ray)
            "a group is entered by its inverse, rounded"
            (Gen.pair some_steps Draw.ray)
            plain_inverse;
        ];
      ] )

open Candor_space
open Candor_surface
open Candor_sample
open Candor_scene
open Candor_optics
open Candor_oracle
open Lit

let pi = Float.pi
let unit_ball = Primitives.Sphere (sphere Point.origin 1.)
let tri = Primitives.Triangle (triangle (p 0. 0. 0.) (p 2. 0. 0.) (p 0. 1. 0.))
let cube = Primitives.Box (box (p (-1.) (-1.) (-1.)) (p 1. 1. 1.))
let plate = Primitives.Box (box (p (-1.) (-1.) 0.) (p 1. 1. 0.))

let egg =
  Primitives.Quadric
    (quadric (Ellipsoid { center = p 0. 0. 0.; radii = Vec.v 1. 2. 0.5 }))

let squeeze =
  transform
    [
      Scale (Vec.v 1. 2. (-0.5));
      Rotate { axis = Vec.v 1. 1. 0.; degrees = 40. };
      Translate (Vec.v 0.5 0. 1.);
    ]

let turn =
  transform
    [
      Scale (Vec.v 2. 2. 2.);
      Rotate { axis = Vec.v 1. 1. 0.; degrees = 40. };
      Scale (Vec.v 1. (-1.) 1.);
      Translate (Vec.v 0.5 0. 1.);
    ]

let target ?transform ?both_sides shape =
  Light_target.of_primitive (emitter ?transform ?both_sides shape)

let small_cap =
  Light_target.cap ~axis:(dir 0. 0.1 1.) ~one_minus_cos:0.1 (target unit_ball)

(* {1 Samples and densities} *)

(* Towards 0, in a cone that holds all of the target if it is not [wide]. *)
let spread ?(wide = false) ?fine ?(cone = 0.5) name target (from : Point.t) =
  (* Aside, so that edges do not run along cells. *)
  let axis = dir (0.3 -. from.x) (0.2 -. from.y) (0.1 -. from.z) in
  let direction (s : Light_target.sample) = s.direction in
  Spread.check ?fine name ~axis
    ~one_minus_cos:(if wide then 2. else cone)
    ~sample:(fun u -> Option.map direction (Light_target.sample target ~from u))
    ~density:(Light_target.density target ~from)

let spreads () =
  let far = p 1. 2. 6. in
  spread "sphere" (target unit_ball) (p 0.5 1. 2.);
  spread ~wide:true "sphere, from next to it" (target unit_ball)
    (p 0. 0. 1.00001);
  spread ~wide:true "sphere, from inside"
    (target ~both_sides:true unit_ball)
    (p 0.5 0.5 0.);
  spread ~cone:0.12 "sphere, turned and mirrored"
    (target ~transform:turn unit_ball)
    far;
  spread ~cone:0.12 "sphere, squeezed" (target ~transform:squeeze unit_ball) far;
  spread ~cone:0.12 ~fine:48 "triangle" (target tri) far;
  spread ~cone:0.12 "triangle, mirrored"
    (target ~transform:squeeze ~both_sides:true tri)
    far;
  spread ~wide:true "triangle, from close by" (target tri) (p 0.5 0.2 0.1);
  spread ~wide:true "box, from close by" (target cube) (p 1.5 1.2 0.3);
  spread ~cone:0.12 "box, from far away" (target cube) far;
  spread "box, squeezed" (target ~transform:squeeze cube) (p 3. 4. 9.);
  spread ~wide:true "box, from inside"
    (target ~both_sides:true cube)
    (p 0.5 0.2 0.1);
  spread ~cone:0.12 ~fine:32 "flat box" (target plate) (p 0. 2. 6.);
  spread ~cone:0.12 ~fine:32 "flat box, from below" (target plate)
    (p 0. 2. (-6.));
  spread ~cone:0.12 ~fine:32 "ellipsoid" (target egg) (p 1. 2. 6.);
  spread ~wide:true "ellipsoid, from inside its box" (target egg)
    (p 0.9 1.9 0.4);
  spread ~cone:0.12 ~fine:32 "cap" small_cap (p 0.1 0.2 3.);
  spread ~wide:true "cap, from close by" small_cap (p 0.1 0.2 1.3)

(* A point of a cap that faces away gives nothing. *)
let turned_away () =
  let from = p 1.4 0. 0.7 in
  let taken = ref 0 in
  let n = 200 in
  for i = 0 to (n * n) - 1 do
    let mid k = (float_of_int k +. 0.5) /. float_of_int n in
    let u = mid (i / n) and v = mid (i mod n) in
    match Light_target.sample small_cap ~from { u; v } with
    | None -> ()
    | Some _ -> incr taken
  done;
  let part = float_of_int !taken /. float_of_int (n * n) in
  let sum = ref 0. in
  let frame = Frame.of_dir Dir.z in
  let m = 1500 in
  for i = 0 to (m * m) - 1 do
    let mid k = (float_of_int k +. 0.5) /. float_of_int m in
    let d = Spread.direction frame 2. (mid (i / m)) (mid (i mod m)) in
    sum := !sum +. Light_target.density small_cap ~from d
  done;
  let all = !sum *. 4. *. pi /. float_of_int (m * m) in
  if not (part > 0.1 && part < 0.9) then Alcotest.failf "%g is seen" part;
  Near.float ~within:0.01 "what is seen" part all

(* {1 Solid angles} *)

let ball_angle r d = 2. *. pi *. (1. -. sqrt (1. -. (r /. d *. (r /. d))))

let angles () =
  let near = Near.float ~within:1e-13 in
  let angle t from = Light_target.solid_angle t ~from in
  near "sphere" (ball_angle 1. 3.) (angle (target unit_ball) (p 0. 3. 0.));
  near "sphere of radius 2" (ball_angle 2. 5.)
    (angle (target ~transform:turn unit_ball) (p 0.5 5. 1.));
  near "sphere, from inside" 0. (angle (target unit_ball) (p 0. 0.5 0.));
  near "sphere that emits inwards too, from inside" (4. *. pi)
    (angle (target ~both_sides:true unit_ball) (p 0. 0.5 0.));
  List.iter
    (fun h ->
      let square = 4. *. Float.asin (1. /. (1. +. (h *. h))) in
      near "square, from above" square (angle (target plate) (p 0. 0. h));
      near "square, from below" square (angle (target plate) (p 0. 0. (-.h)));
      near "face of a cube" square (angle (target cube) (p 0. 0. (1. +. h))))
    [ 0.01; 1.; 5. ];
  near "cube, from inside" 0. (angle (target cube) (p 0. 0.5 0.));
  near "cube that emits inwards too, from inside" (4. *. pi)
    (angle (target ~both_sides:true cube) (p 0. 0.5 0.));
  near "triangle, from behind" 0. (angle (target tri) (p 0. 0. (-1.)));
  near "both sides of a triangle are alike"
    (angle (target tri) (p 0. 1. 1.))
    (angle (target ~both_sides:true tri) (p 0. 1. (-1.)));
  let relative = angle (target unit_ball) (p 0. 0x1p40 0.) /. (pi *. 0x1p-80) in
  near "sphere from far away, relative" 1. relative

(* The number of directions to what is in a box that hit it, over their density,
   is its own solid angle. *)
let hits shape transform_ from expected =
  let e = emitter ?transform:transform_ shape in
  let surface =
    Surface.seen_through ?transform:transform_
      (match shape with
      | Primitives.Quadric q -> Surface.quadric q ()
      | Sphere s -> Surface.sphere s ()
      | Box b -> Surface.box b ()
      | Triangle s -> Surface.triangle s ())
  in
  let target = Light_target.of_primitive e in
  let n = 150 in
  let sum = ref 0. in
  for i = 0 to (n * n) - 1 do
    let mid k = (float_of_int k +. 0.5) /. float_of_int n in
    let u = mid (i / n) and v = mid (i mod n) in
    match Light_target.sample target ~from { u; v } with
    | None -> ()
    | Some { direction; density } ->
        let ray = Ray.v from (direction :> Vec.t) in
        if Surface.blocked surface ~limit:infinity ray then
          sum := !sum +. (1. /. density)
  done;
  Near.float ~within:0.01 "its own solid angle" expected
    (!sum /. float_of_int (n * n))

let in_boxes () =
  let round =
    Primitives.Quadric
      (quadric (Ellipsoid { center = Point.origin; radii = Vec.v 1. 1. 1. }))
  in
  hits round None (p 2. 1. 2.) (ball_angle 1. 3.);
  hits round None (p 0.9 0.9 0.9) (ball_angle 1. (0.9 *. sqrt 3.));
  let half = transform [ Scale (Vec.v 1. 2. 0.5) ] in
  let flat =
    Primitives.Quadric
      (quadric (Ellipsoid { center = Point.origin; radii = Vec.v 1. 0.5 2. }))
  in
  hits flat (Some half) (p 2. 1. 2.) (ball_angle 1. 3.);
  let oval = Primitives.Sphere (sphere Point.origin 1.)
  and widen = transform [ Scale (Vec.v 1. 1. 2.) ] in
  (* From the axis, a spheroid looks as its rim does. *)
  hits oval (Some widen) (p 0. 0. 4.)
    (2. *. pi *. (1. -. (sqrt 12. /. sqrt 13.)));
  let sheet =
    Primitives.Quadric
      (quadric
         (Plane { normal = Vec.v 0. 0. 2.; offset = 1. })
         ~clip:(Bounds.v (p (-1.) (-1.) (-3.)) (p 1. 1. 3.)))
  in
  hits sheet None (p 0. 0. 1.5) (4. *. Float.asin 0.5);
  Near.float "a clipped plane is a rectangle"
    (4. *. Float.asin 0.5)
    (Light_target.solid_angle (target sheet) ~from:(p 0. 0. (-0.5)))

(* {1 Laws} *)

open QCheck2.Gen

let shapes =
  [
    ("sphere", target unit_ball);
    ("sphere, both", target ~both_sides:true unit_ball);
    ("sphere, squeezed", target ~transform:squeeze unit_ball);
    ("triangle", target tri);
    ("triangle, both", target ~both_sides:true tri);
    ("box", target cube);
    ("box, both", target ~both_sides:true cube);
    ("flat box", target plate);
    ("ellipsoid", target egg);
    ("cap", small_cap);
  ]

let view =
  let* name, target = Draw.pick shapes in
  let* from =
    oneof
      [
        Draw.point (Draw.uniform (-3.) 3.);
        Draw.point (Draw.small 2);
        Draw.point (Draw.signed (Draw.wide (-3.) 3.));
      ]
  in
  let* u = Draw.uniform 0.001 0.999 and* v = Draw.uniform 0.001 0.999 in
  return (name, target, from, { Pattern.u; v })

let show (name, _, from, { Pattern.u; v }) =
  Printf.sprintf "%s from %s at %h %h" name (Draw.show_point from) u v

let agree (_, target, from, p) =
  match Light_target.sample target ~from p with
  | None -> true
  | Some { direction; density } ->
      let again = Light_target.density target ~from direction in
      Float.abs (again -. density) <= 1e-9 *. density
      || Law.fail "%.17g, not %.17g" again density

let somewhere (name, target, from, p) =
  let angle = Light_target.solid_angle target ~from in
  if not (angle >= 0. && angle <= (4. *. pi) +. 1e-9) then
    Law.fail "solid angle %g" angle
  else
    match Light_target.sample target ~from p with
    | None -> angle = 0. || name = "cap"
    | Some { density; _ } ->
        angle > 0.
        && (List.mem name [ "cap"; "ellipsoid"; "sphere, squeezed" ]
           || Near.close ~within:1e-9 (density *. angle) 1.)

let same_sample (a : Light_target.sample option) b =
  match (a, b) with
  | None, None -> true
  | Some a, Some (b : Light_target.sample) ->
      same_dir a.direction b.direction && same_bits a.density b.density
  | None, Some _ | Some _, None -> false

(* One look serves for a solid angle and for two samples. Where the target is not
   flat, nothing need be seen of it; where it is, the density of what is sampled,
   which looks by itself, is one over the solid angle. *)
let looked_at_once (_, target, from, { Pattern.u; v }) =
  let flat = Light_target.is_flat target in
  let look =
    if flat then Light_target.look target ~from else Light_target.nothing
  in
  let angle = Light_target.solid_angle_seen look target ~from in
  let alike p =
    let seen = Light_target.sample_seen look target ~from p in
    same_sample seen (Light_target.sample target ~from p)
    &&
    match seen with
    | None -> (not flat) || angle = 0.
    | Some { direction; _ } when flat ->
        let density = Light_target.density target ~from direction in
        Near.close ~within:1e-9 (density *. angle) 1.
    | Some _ -> true
  in
  same_bits angle (Light_target.solid_angle target ~from)
  && alike { u; v }
  && alike { u = v; v = u }

let flat_ones () =
  List.iter
    (fun (name, target) ->
      let flat =
        List.exists
          (fun prefix -> String.starts_with ~prefix name)
          [ "triangle"; "box"; "flat box" ]
      in
      Alcotest.(check bool) name flat (Light_target.is_flat target))
    shapes

let scaled k shape =
  let at (q : Point.t) = p (k *. q.x) (k *. q.y) (k *. q.z) in
  match shape with
  | Primitives.Sphere s ->
      Primitives.Sphere (sphere (at (Sphere.center s)) (k *. s.radius))
  | Box b ->
      let b = Box.bounds b in
      Box (box (at (Bounds.low b)) (at (Bounds.high b)))
  | Triangle { corners = { a; b; c }; _ } ->
      Triangle (triangle (at a) (at b) (at c))
  | Quadric q -> (
      match Quadric.shape q with
      | Ellipsoid { center; radii } ->
          Quadric
            (quadric
               (Ellipsoid { center = at center; radii = Vec.scale k radii }))
      | _ -> Quadric q)

let scaling =
  let* shape = Draw.pick [ unit_ball; tri; cube; plate; egg ]
  and* both_sides = bool
  and* e = oneof [ int_range (-350) 350; int_range (-4) 4 ] in
  let* _, _, from, uv = view in
  return (shape, both_sides, e, from, uv)

let show_scaling (_, both, e, from, { Pattern.u; v }) =
  Printf.sprintf "%b times 2^%d from %s at %h %h" both e (Draw.show_point from)
    u v

let same_when_scaled (shape, both_sides, e, from, uv) =
  let k = Float.ldexp 1. e in
  let one = target ~both_sides shape
  and other = target ~both_sides (scaled k shape) in
  let axis = dir 1. 2. 3. in
  let cap t = Light_target.cap ~axis ~one_minus_cos:0.2 t in
  let alike one other =
    let from' = Point.ldexp e from in
    same_bits
      (Light_target.solid_angle one ~from)
      (Light_target.solid_angle other ~from:from')
    &&
    let sample = Light_target.sample one ~from uv in
    same_sample sample (Light_target.sample other ~from:from' uv)
    &&
    match sample with
    | None -> true
    | Some { direction; _ } ->
        same_bits
          (Light_target.density one ~from direction)
          (Light_target.density other ~from:from' direction)
  in
  alike one other && alike (cap one) (cap other)

(* {1 Corners} *)

let extreme () =
  let sides = [ 0x1p-398; 1.; 0x1p398 ] in
  let froms =
    List.concat_map
      (fun x -> [ p x 0. 0.; p 0. x x; p (-.x) x 0.; p x x x ])
      [ 0.; 0x1p-400; 1.; 0x1p400 ]
  in
  List.iter
    (fun k ->
      List.iter
        (fun shape ->
          let t = target (scaled k shape) in
          List.iter
            (fun from ->
              let angle = Light_target.solid_angle t ~from in
              if not (angle >= 0. && angle < 13.) then
                Alcotest.failf "solid angle %g" angle;
              match Light_target.sample t ~from { u = 0.; v = 0.5 } with
              | None -> ()
              | Some { direction; density } ->
                  if
                    not
                      (density > 0. && density < infinity
                      && Vec.is_finite (direction :> Vec.t))
                  then Alcotest.failf "density %g" density)
            froms)
        [ unit_ball; tri; cube; plate; egg ])
    sides;
  let plane = quadric (Plane { normal = Vec.v 0. 1. 0.; offset = 0. }) in
  let t = target (Quadric plane) in
  Near.float "unbounded" 0. (Light_target.solid_angle t ~from:(p 0. 1. 0.))

let suite =
  ( "light target",
    [
      Law.example "directions are spread as their density says" spreads;
      Law.example "what of a cap faces away is not seen" turned_away;
      Law.example "solid angles are those of closed forms" angles;
      Law.example "directions to a box find what is in it" in_boxes;
      Law.law ~print:show "the density of a sample is that of its direction"
        view agree;
      Law.law ~print:show "something is sampled where something is seen" view
        somewhere;
      Law.law ~count:5000 ~print:show
        "what is seen once is sampled as if it were looked at anew" view
        looked_at_once;
      Law.example "targets of facets are flat, balls and caps are not" flat_ones;
      Law.law ~print:show_scaling "scaling by 2^k leaves the bits" scaling
        same_when_scaled;
      Law.example "the largest and smallest lights are safe" extreme;
    ] )

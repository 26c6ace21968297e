open Candor_space
open Candor_scene
open Candor_optics
open Candor_oracle
open Candor_scene_made
open QCheck2

let camera ?near ?(up = Vec.v 0. 1. 0.) ~eye ~look_at frame =
  {
    Camera.eye;
    look_at;
    up;
    frame;
    near;
    lens = None;
    shutter = Camera.instant;
    place = Place.unknown;
  }

let p = Point.v
let at_origin = camera ~eye:(p 0. 0. 5.) ~look_at:Point.origin
let half : Camera.window = { left = -0.5; right = 2.; bottom = -1.; top = 3. }
let ray c ?(width = 4) ?(height = 2) x y = Aim.compile c ~width ~height x y

(* The ray through (x, y) starts at [o] and goes along [d]. *)
let check name c ?width ?height (x, y) o d =
  let { Ray.origin; direction; departure } = ray c ?width ?height x y in
  Near.point (name ^ ", origin") o origin;
  Near.vec (name ^ ", direction") d direction;
  Alcotest.(check bool) "from nowhere" true (departure = Nowhere)

let perspective () =
  let c = at_origin (Perspective_angle { fov_y = 90. }) in
  let eye = (0., 0., 5.) in
  check "the middle" c (2., 1.) eye (0., 0., -1.);
  check "the top" c (2., 0.) eye (0., 1., -1.);
  check "the bottom" c (2., 2.) eye (0., -1., -1.);
  check "the left, by the aspect of 2" c (0., 1.) eye (-2., 0., -1.);
  check "the top right" c (4., 0.) eye (2., 1., -1.);
  check "the centre of pixel 0 0" c (0.5, 0.5) eye (-1.5, 0.5, -1.);
  check "a tall picture" c ~width:2 ~height:4 (0., 0.) eye (-0.5, 1., -1.)

let angle =
  Law.law ~print:string_of_float
    "the top of the picture is at half the angle of view" (Draw.uniform 1. 179.)
    (fun fov_y ->
      let d = (ray (at_origin (Perspective_angle { fov_y })) 2. 0.).direction in
      Near.close ~within:1e-12 (atan2 d.y (-.d.z) *. 360. /. Float.pi) fov_y)

let window () =
  let c = at_origin (Perspective_window { window = half; distance = 2. }) in
  let eye = (0., 0., 5.) in
  check "left and top" c (0., 0.) eye (-0.25, 1.5, -1.);
  check "right and bottom" c (4., 2.) eye (1., -0.5, -1.);
  check "left and bottom" c (0., 2.) eye (-0.25, -0.5, -1.);
  (* u = L + (R - L)(i + .5)/W, v = T - (T - B)(j + .5)/H *)
  check "pixel 1 0" c (1.5, 0.5) eye
    ((-0.5 +. (2.5 *. 1.5 /. 4.)) /. 2., (3. -. (4. *. 0.5 /. 2.)) /. 2., -1.)

let orthographic () =
  let c = at_origin (Orthographic_height { height = 6. }) in
  let d = (0., 0., -1.) in
  check "the middle" c (2., 1.) (0., 0., 5.) d;
  check "the top left" c (0., 0.) (-6., 3., 5.) d;
  check "the bottom right" c (4., 2.) (6., -3., 5.) d;
  let c = at_origin (Orthographic_window { window = half }) in
  check "a window's top left" c (0., 0.) (-0.5, 3., 5.) d;
  check "a window's bottom right" c (4., 2.) (2., -1., 5.) d

let near () =
  let c = camera ~near:1.5 ~eye:(p 0. 0. 5.) ~look_at:Point.origin in
  let corner = c (Perspective_angle { fov_y = 90. }) in
  check "the near plane, in the middle" corner (2., 1.) (0., 0., 3.5)
    (0., 0., -1.);
  check "the near plane, in a corner" corner (0., 0.) (-3., 1.5, 3.5)
    (-2., 1., -1.);
  check "orthographic"
    (c (Orthographic_height { height = 2. }))
    (0., 0.) (-2., 1., 3.5) (0., 0., -1.)

let turned () =
  let c = camera ~up:(Vec.v 0. 0. 7.) ~eye:Point.origin ~look_at:(p 9. 0. 0.) in
  check "z up, looking along x"
    (c (Perspective_angle { fov_y = 90. }))
    ~width:2 (0., 0.) (0., 0., 0.) (1., 1., 1.);
  let c = camera ~up:(Vec.v 5. 1. 0.) ~eye:Point.origin ~look_at:(p 9. 0. 0.) in
  check "a slanting up is straightened"
    (c (Orthographic_height { height = 2. }))
    ~width:2 (0., 0.) (0., 1., -1.) (1., 0., 0.)

let frames : Camera.frame list =
  [
    Perspective_angle { fov_y = 50. };
    Perspective_window { window = half; distance = 1.5 };
    Orthographic_height { height = 3. };
    Orthographic_window { window = half };
  ]

let quarter = Gen.map (fun x -> x /. 4.) (Draw.small 40)

let view =
  Gen.(
    quad (Draw.point quarter) (Draw.point quarter) (Draw.vec quarter)
      (pair (Draw.uniform 0. 4.) (Draw.uniform 0. 2.)))

let sees (eye, look_at, up, _) =
  Vec.largest (Vec.cross up (Point.sub look_at eye)) > 0.

let show_view (eye, look_at, up, (x, y)) =
  Printf.sprintf "eye %s look-at %s up %s at %g %g" (Draw.show_point eye)
    (Draw.show_point look_at) (Draw.show_vec up) x y

let far ((eye, look_at, up, (x, y)) as view) =
  (* Quarters and 10^9 add up exactly. *)
  let move p = Point.add p (Vec.v 1e9 (-1e9) 1e9) in
  (not (sees view))
  || List.for_all
       (fun frame ->
         let near = ray (camera ~up ~eye ~look_at frame) x y
         and far =
           ray (camera ~up ~eye:(move eye) ~look_at:(move look_at) frame) x y
         in
         Vec.equal near.direction far.direction)
       frames

(* Beside 1e9 + 1e-3 there is no double within 1e-8. *)
let fine_pitch () =
  let window : Camera.window =
    { left = -0.32; right = 0.32; bottom = -0.24; top = 0.24 }
  in
  let c =
    camera ~eye:(p 1e9 0. 0.) ~look_at:(p 1e9 0. (-1.)) ~up:(Vec.v 0. 1. 0.)
      (Perspective_window { window; distance = 1. })
  in
  let pixel i = (ray c ~width:640 ~height:480 i 0.5).direction.x in
  List.iter
    (fun i ->
      let pitch = pixel (i +. 1.) -. pixel i in
      Alcotest.(check (float 1e-15)) "the pitch" 1e-3 pitch)
    (List.init 639 (fun i -> float_of_int i +. 0.5))

let scaled ((eye, look_at, up, (x, y)) as view) =
  (not (sees view))
  || List.for_all
       (fun frame ->
         List.for_all
           (fun k ->
             let c = camera ~near:0.75 ~up ~eye ~look_at frame in
             let small = ray c x y and large = ray (Scaled.camera k c) x y in
             Vec.equal small.direction large.direction
             && Point.equal (Scaled.point k small.origin) large.origin)
           [ 0x1p20; 0x1p-20 ])
       frames

(* The line of sight counts 1 along every ray, and the basis is orthonormal. *)
let along_sight ((eye, look_at, up, (x, y)) as view) =
  (not (sees view))
  ||
  let c = camera ~up ~eye ~look_at (Perspective_angle { fov_y = 50. }) in
  let d = (ray c x y).direction and f = (ray c 2. 1.).direction in
  let above = Vec.sub (ray c 2. 0.).direction f
  and right = Vec.sub (ray c 4. 1.).direction f in
  Near.close (Vec.dot d f) 1.
  && Near.close (Vec.dot above f) 0.
  && Near.close (Vec.dot above right) 0.
  && Near.close (Vec.norm right) (2. *. Vec.norm above)
  && Vec.dot (Vec.cross right above) f < 0.

let law name f = Law.law ~print:show_view name view f

(* {1 Panoramas and lenses} *)

let panorama () =
  let c = at_origin Camera.Panorama in
  let eye = (0., 0., 5.) in
  let check name at d = check name c ~width:8 ~height:4 at eye d in
  check "the middle looks at look-at" (4., 2.) (0., 0., -1.);
  check "a quarter to the right" (6., 2.) (1., 0., 0.);
  check "a quarter to the left" (2., 2.) (-1., 0., 0.);
  check "the edge looks back" (0., 2.) (0., 0., 1.);
  check "the top looks up" (1., 0.) (0., 1., 0.);
  check "the bottom looks down" (3., 4.) (0., -1., 0.);
  let k = sqrt 0.5 in
  check "half up" (4., 1.) (0., k, -.k)

let lens ?(frame = Camera.Perspective_angle { fov_y = 60. }) radius focus =
  let c = camera ~eye:(p 1. 2. 3.) ~look_at:(p 2. 0. (-7.)) frame in
  ( (fun x y u v ->
      Aim.compile_lens c { radius; focus } ~width:4 ~height:2 x y { u; v }),
    fun x y -> Aim.compile c ~width:4 ~height:2 x y )

let place =
  Gen.(
    quad (Draw.uniform 0. 4.) (Draw.uniform 0. 2.) (Draw.uniform 0. 1.)
      (Draw.uniform 0. 1.))

let show_place (x, y, u, v) = Printf.sprintf "%g %g by %g %g" x y u v

let focused (x, y, u, v) =
  let through, middle = lens 0.75 8. in
  let a = through x y u v and b = middle x y in
  let on (ray : Ray.t) = Point.along ray.origin ray.direction 8. in
  let off = Point.sub (on a) (on b) in
  let aside = Point.sub a.origin b.origin in
  Vec.norm off < 1e-13
  && Vec.norm aside <= 0.75 +. 1e-12
  && Near.close (Vec.dot aside (middle 2. 1.).direction) 0.

let closed (x, y, u, v) =
  let through, middle = lens 0. 8. in
  let a = through x y u v and b = middle x y in
  Vec.equal a.direction b.direction && Point.equal a.origin b.origin

let no_lens (x, y, u, v) =
  List.for_all
    (fun frame ->
      let through, middle = lens ~frame 2. 8. in
      let a = through x y u v and b = middle x y in
      Vec.equal a.direction b.direction && Point.equal a.origin b.origin)
    [ Camera.Panorama; Orthographic_height { height = 3. } ]

let place_law name f = Law.law ~print:show_place name place f

let suite =
  ( "cameras",
    [
      Law.example
        "perspective: half the height is at tan(fov/2), the width by the aspect"
        perspective;
      angle;
      Law.example "perspective through a window, the right way up" window;
      Law.example "orthographic: parallel rays from the picture's plane"
        orthographic;
      Law.example "rays start on the near plane" near;
      Law.example "other directions of up" turned;
      Law.example "G10: a camera at 1e9 tells pixels apart that are 1e-3 wide"
        fine_pitch;
      law
        "G10: a camera 1e9 from the origin sends the same directions, to the \
         bit"
        far;
      law "scaling by 2^k keeps directions and scales origins, to the bit"
        scaled;
      Law.example "a panorama looks all around" panorama;
      place_law "all rays of a lens meet in the plane of focus" focused;
      place_law "a closed lens is a pinhole, to the bit" closed;
      place_law "cameras without perspective have no lens" no_lens;
      law
        "rays advance by 1 along the line of sight; up is up and right is right"
        along_sight;
    ] )

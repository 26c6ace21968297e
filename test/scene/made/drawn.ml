(** Valid scenes drawn at random: small pictures of every kind of surface,
    material, light, background and camera. *)

open Candor_space
open Candor_colour
open Candor_surface
open Candor_scene
open Candor_oracle
open QCheck2
open Gen

type 'a gen = 'a Gen.t

(** How numbers are drawn: [Round] ones make surfaces touch and coincide,
    [Loose] ones make that as good as impossible. *)
type style = Round | Loose

let number style lo hi =
  match style with
  | Loose -> Draw.uniform lo hi
  | Round ->
      let+ x = Draw.uniform lo hi and+ round = bool in
      if round then Float.round (2. *. x) /. 2. else x

let place_of n = { Place.file = "drawn.scene"; line = n; column = 1 }
let unit_sphere = Scaled.valid (Sphere.make ~center:Point.origin ~radius:1.)

(** Some point of a surface, for tests that need one. *)
let some_point =
  let ray = Object_ray.v (Point.v 0. 0. 5.) (Vec.v 0. 0. (-1.)) in
  Sphere.locate unit_sphere ray 4. (Contact.v ~part:0 Outside)

let rgb =
  let+ r = Draw.pick [ 0.; 0.2; 0.5; 0.75; 1. ]
  and+ g = Draw.uniform 0. 1.
  and+ b = Draw.uniform 0. 1.
  and+ kind = int_bound 7 in
  if kind = 0 then Rgb.black else if kind = 1 then Rgb.grey r else Rgb.v r g b

let texture =
  let constant = map (fun c -> Texture.Constant c) rgb in
  let checker below =
    let+ even = below
    and+ odd = below
    and+ scale = Draw.pick [ 0.5; 1.; 0.3 ] in
    Texture.Checker { even; odd; scale }
  in
  oneof [ constant; constant; checker constant; checker (checker constant) ]

let material : Material.t gen =
  let* color = texture
  and* c = rgb
  and* shininess = Draw.pick [ 0.; 1.; 20.; 1000. ] in
  let+ kind =
    Draw.pick
      [
        Material.Matte { color };
        Phong { color; specular = c; shininess };
        Mirror { color };
        Glazed { color; mirror = c };
      ]
  in
  Material.v kind

let point style =
  let coordinate = number style (-2.) 2. in
  map3 Point.v coordinate coordinate coordinate

let vec style =
  map3 Vec.v (number style (-2.) 2.) (number style (-2.) 2.)
    (number style (-2.) 2.)

let radius style = map (fun r -> Float.abs r +. 0.2) (number style 0. 1.8)

let sphere style : Scene.shape gen =
  let+ center = point style and+ radius = radius style in
  Scene.Sphere (Scaled.valid (Sphere.make ~center ~radius))

(* What cannot be made is replaced by a sphere. *)
let or_sphere style made wrap =
  match made with Ok x -> pure (wrap x) | Error _ -> sphere style

let box style =
  let* a = point style
  and+ size = map3 Vec.v (radius style) (radius style) (radius style)
  and+ flat = int_bound 5 in
  let size =
    if flat = 0 then { size with x = 0. }
    else if flat = 1 then { size with y = 0. }
    else size
  in
  or_sphere style
    (Box.make ~min:a ~max:(Point.add a size))
    (fun b -> Scene.Box b)

let triangle style =
  let* a = point style
  and+ b = point style
  and+ c = point style
  and+ normals =
    let normal = vec style in
    option (triple normal normal normal)
  and+ uv = bool in
  let uv =
    if uv then
      Some { Triangle.ua = 0.; va = 0.; ub = 1.; vb = 0.; uc = 0.; vc = 2. }
    else None
  in
  or_sphere style
    (Triangle.make ?normals ?uv { a; b; c })
    (fun t -> Scene.Triangle t)

let quadric_shape style : Quadric_shape.t gen =
  let* p = point style
  and* q = point style
  and* v = vec style
  and* a = radius style
  and* b = radius style
  and* c = radius style
  and* offset = number style (-2.) 2. in
  let radii = Vec.v a b c in
  Draw.pick
    [
      Quadric_shape.Plane { normal = v; offset };
      Ellipsoid { center = p; radii };
      Cylinder { from = p; until = q; radius = a };
      Cone { apex = p; base = q; radius = a };
      Paraboloid { apex = p; base = q; radius = a };
      Hyperbolic_paraboloid { center = p; radii };
      Hyperboloid_one_sheet { center = p; radii };
      Hyperboloid_two_sheets { center = p; radii };
      Form { a = [| a; 0.; v.x; 0.; b; 0.; v.x; 0.; -.c |]; b = v; c = offset };
      Matrix
        [|
          a; v.x; 0.; v.y; v.x; b; 0.; 0.; 0.; 0.; v.z; 1.; v.y; 0.; 1.; offset;
        |];
    ]

let capped : Quadric_shape.t -> bool = function
  | Cylinder _ | Cone _ | Paraboloid _ -> true
  | Matrix _ | Form _ | Plane _ | Ellipsoid _ | Hyperbolic_paraboloid _
  | Hyperboloid_one_sheet _ | Hyperboloid_two_sheets _ ->
      false

let quadric style =
  let* shape = quadric_shape style
  and+ caps = bool
  and+ clipped = bool
  and+ low = point style
  and+ size = map3 Vec.v (radius style) (radius style) (radius style) in
  let clip =
    if clipped then Some (Bounds.v low (Point.add low (Vec.scale 3. size)))
    else None
  in
  or_sphere style
    (Quadric.make ?clip ~caps:(caps && capped shape) shape)
    (fun q -> Scene.Quadric q)

(* A star around the origin, not convex for most radii, moved and tilted. *)
let polygon style =
  let* radii = list_size (int_range 3 8) (radius style)
  and+ middle = point style
  and+ slope = number style (-1.) 1. in
  let n = float_of_int (List.length radii) in
  let corner i r =
    let turn =
      Candor_oracle.Draw.rounded 8 (2. *. Float.pi *. float_of_int i /. n)
    in
    let x = Draw.rounded 8 (r *. cos turn)
    and y = Draw.rounded 8 (r *. sin turn) in
    let slope = Draw.rounded 3 slope in
    Point.v
      (Draw.rounded 8 middle.x +. x)
      (Draw.rounded 8 middle.y +. y)
      (Draw.rounded 8 middle.z +. (slope *. x))
  in
  or_sphere style
    (Polygon.make (List.mapi corner radii))
    (fun p -> Scene.Polygon p)

let step style : Transform.step gen =
  let* v = vec style
  and* k = Draw.pick [ 0.5; 2.; -1.; 1.25 ]
  and* degrees = Draw.pick [ 90.; 30.; -45.; 180.; 7. ]
  and* axis = Draw.unit in
  let shear = { Affine.identity with xy = v.x; zt = v.y; yt = v.z } in
  Draw.pick
    [
      Transform.Translate v;
      Scale (Vec.v k k k);
      Scale (Vec.v 1. k 0.75);
      Rotate { axis; degrees };
      Matrix shear;
    ]

let steps style = list_size (int_bound 3) (step style)

let used_material names =
  let named = map (fun n -> Scene.Named n) (Draw.pick names) in
  oneof
    [
      pure None;
      map Option.some named;
      map (fun m -> Some (Scene.Inline m)) material;
    ]

(* [definitions] are the names that may be used here. *)
let rec surface style ~depth ~definitions ~materials : Scene.surface gen =
  let simple =
    [
      sphere style;
      sphere style;
      box style;
      triangle style;
      quadric style;
      polygon style;
    ]
  in
  let group () =
    let* transform = steps style in
    let+ surfaces =
      list_size (int_range 0 3)
        (surface style ~depth:(depth - 1) ~definitions ~materials)
    in
    Scene.Group { transform; surfaces }
  in
  let use () =
    let+ transform = steps style
    and+ aside = vec style
    and+ name = Draw.pick definitions in
    (* Two uses in one place would coincide. *)
    let apart =
      match style with Loose -> [ Transform.Translate aside ] | Round -> []
    in
    Scene.Use { transform = apart @ transform; name }
  in
  let nested = if depth > 0 then [ group () ] else [] in
  let shared = if definitions = [] then [] else [ use () ] in
  let+ shape = oneof (simple @ nested @ shared)
  and+ material = used_material materials
  and+ line = int_range 1 9999 in
  { (Scene.plain shape (place_of line)) with material }

let falloff = Draw.pick [ Light.Square; Light.Square; Light.Constant ]

let light style =
  let* at = point style
  and* toward = point style
  and* v = vec style
  and* c = rgb
  and* bright = Draw.pick [ 1.; 10.; 300. ]
  and* falloff = falloff
  and* a = Draw.uniform 0. 90.
  and* b = Draw.uniform 0. 90. in
  let at = Point.add at (Vec.v 0. 4. 2.) in
  let intensity = Rgb.scale bright c in
  let direction = if Vec.largest v > 0. then v else Vec.v 0. (-1.) 0. in
  let toward =
    if Point.equal at toward then Point.add at (Vec.v 1. 0. 0.) else toward
  in
  let+ kind =
    Draw.pick
      [
        Light.Point { at; intensity; falloff };
        Directional { direction; irradiance = c };
        Spot
          {
            at;
            toward;
            intensity;
            inner = Float.min a b;
            outer = Float.max a b;
            falloff;
          };
      ]
  and+ shadows = map (fun n -> n > 0) (int_bound 3) in
  fun line -> { Light.kind; shadows; place = place_of line }

let lights style =
  let+ makers = list_size (int_range 0 5) (light style) in
  List.mapi (fun i make -> make (10000 + i)) makers

let background =
  let+ down = rgb and+ up = rgb and+ uniform = bool in
  if uniform then Scene.Uniform up else Scene.Gradient { down; up }

let window =
  let+ l = Draw.uniform (-3.) (-0.5)
  and+ r = Draw.uniform 0.5 3.
  and+ b = Draw.uniform (-3.) (-0.5)
  and+ t = Draw.uniform 0.5 3. in
  { Camera.left = l; right = r; bottom = b; top = t }

let camera style =
  let* look_at = Draw.point (number style (-0.6) 0.6)
  and* away = Draw.unit
  and* distance = Draw.uniform 3. 7.
  and* up = Draw.unit
  and* window = window
  and* fov_y = Draw.uniform 20. 70.
  and* near = option (Draw.uniform 0.1 2.) in
  let eye = Point.add look_at (Vec.scale distance away) in
  (* Any direction that is not along the view. *)
  let up =
    if Vec.norm (Vec.cross up away) > 0.01 then up
    else Vec.v away.y away.z (-.away.x)
  in
  let up =
    if Vec.norm (Vec.cross up away) > 0.01 then up else Vec.v 0.3 1. 0.1
  in
  let+ frame =
    Draw.pick
      [
        Camera.Perspective_angle { fov_y };
        Camera.Perspective_angle { fov_y };
        Perspective_window { window; distance = 2. };
        Orthographic_height { height = 6. };
        Orthographic_window { window };
      ]
  in
  {
    Camera.eye;
    look_at;
    up;
    frame;
    near;
    lens = None;
    shutter = Camera.instant;
    place = place_of 5;
  }

let settings =
  let+ spp = int_range 1 4
  and+ depth = map Option.some (int_bound 5)
  and+ cutoff = Draw.pick [ 0.; 0.; 0.3 ]
  and+ seed = int_bound 1000
  and+ filter = Draw.pick [ (Box : Scene.filter); Tent ] in
  { Scene.default_settings with spp; depth; cutoff; seed; filter }

let named name value = { Scene.name; value; place = place_of 1 }

(** [scene style] is a scene of a few surfaces; two definitions, the second of
    which may use the first, and three materials, used or not. *)
let scene ?(most = 8) style =
  let materials = [ "one"; "two"; "three" ] in
  let surface ~definitions = surface style ~depth:2 ~definitions ~materials in
  let* width = int_range 1 12 and* height = int_range 1 9 in
  let* first = list_size (int_bound 2) (surface ~definitions:[]) in
  let* second = list_size (int_bound 3) (surface ~definitions:[ "first" ]) in
  let* surfaces =
    list_size (int_range 2 most) (surface ~definitions:[ "first"; "second" ])
  in
  let* values = list_size (pure 3) material in
  let* camera = camera style and* background = background in
  let* ambient = option rgb and* settings = settings in
  let+ lights = lights style in
  {
    Scene.width;
    height;
    camera;
    background;
    ambient =
      Option.map (fun value -> { Scene.value; place = place_of 2 }) ambient;
    indirect = None;
    fog = None;
    settings;
    lights;
    materials = List.map2 named materials values;
    definitions = [ named "first" first; named "second" second ];
    surfaces;
  }

(** [show s] is [s] as a scene file. *)
let show = Candor_read.Scene_printer.to_string

(** A scene with every length multiplied by a power of two, and what goes with
    lengths: intensities by its square, what is per unit length by its inverse.
    An image on a plane is left as it is, for it has no scale of its own. *)

open Candor_space
open Candor_colour
open Candor_surface
open Candor_scene

let valid = function Ok x -> x | Error why -> invalid_arg why
let point k (p : Point.t) = Point.v (k *. p.x) (k *. p.y) (k *. p.z)

let bounds k (b : Bounds.t) =
  Bounds.v (point k (Bounds.low b)) (point k (Bounds.high b))

let sphere k (s : Sphere.t) =
  valid
    (Sphere.make ~center:(point k (Sphere.center s)) ~radius:(k *. s.radius))

let box k (b : Box.t) =
  let b = (b :> Bounds.t) in
  valid (Box.make ~min:(point k (Bounds.low b)) ~max:(point k (Bounds.high b)))

let triangle k ({ corners = { a; b; c }; normals; uv } : Triangle.t) =
  let corners = { Triangle.a = point k a; b = point k b; c = point k c } in
  valid (Triangle.make ?normals ?uv corners)

(* Of a symmetric 4×4 matrix the last row and column are lengths, the last entry
   a length squared. *)
let entry k i x =
  let last n = if n = 3 then k else 1. in
  last (i / 4) *. last (i mod 4) *. x

let shape k : Quadric_shape.t -> Quadric_shape.t = function
  | Matrix q -> Matrix (Array.mapi (entry k) q)
  | Form { a; b; c } -> Form { a; b = Vec.scale k b; c = k *. k *. c }
  | Plane { normal; offset } -> Plane { normal; offset = k *. offset }
  | Ellipsoid { center; radii } ->
      Ellipsoid { center = point k center; radii = Vec.scale k radii }
  | Cylinder { from; until; radius } ->
      Cylinder
        { from = point k from; until = point k until; radius = k *. radius }
  | Cone { apex; base; radius } ->
      Cone { apex = point k apex; base = point k base; radius = k *. radius }
  | Paraboloid { apex; base; radius } ->
      Paraboloid
        { apex = point k apex; base = point k base; radius = k *. radius }
  | Hyperbolic_paraboloid { center; radii } ->
      Hyperbolic_paraboloid
        { center = point k center; radii = Vec.scale k radii }
  | Hyperboloid_one_sheet { center; radii } ->
      Hyperboloid_one_sheet
        { center = point k center; radii = Vec.scale k radii }
  | Hyperboloid_two_sheets { center; radii } ->
      Hyperboloid_two_sheets
        { center = point k center; radii = Vec.scale k radii }

let quadric k q =
  valid
    (Quadric.make
       ?clip:(Option.map (bounds k) (Quadric.clip q))
       ~caps:(Quadric.caps q)
       (shape k (Quadric.shape q)))

let step k : Transform.step -> Transform.step = function
  | Translate v -> Translate (Vec.scale k v)
  | (Scale _ | Rotate _) as step -> step
  | Matrix m -> Matrix { m with xt = k *. m.xt; yt = k *. m.yt; zt = k *. m.zt }

let rec texture k : Texture.t -> Texture.t = function
  | Constant _ as c -> c
  | Checker { even; odd; scale } ->
      Checker { even = texture k even; odd = texture k odd; scale = k *. scale }
  | Noise { first; second; scale; octaves } ->
      let first = texture k first and second = texture k second in
      Noise { first; second; scale = k *. scale; octaves }
  | Image _ as i -> i

(* What is per unit length. *)
let rate k c = Rgb.scale (1. /. k) c

let material_kind k : Material.kind -> Material.kind = function
  | Matte { color } -> Matte { color = texture k color }
  | Phong m -> Phong { m with color = texture k m.color }
  | Mirror { color } -> Mirror { color = texture k color }
  | Glazed m -> Glazed { m with color = texture k m.color }
  | Glass m ->
      let color = texture k m.color and absorption = rate k m.absorption in
      Glass { m with color; absorption }
  | Metal m -> Metal { m with reflectance = texture k m.reflectance }
  | Plastic m -> Plastic { m with color = texture k m.color }
  | Translucent m ->
      let scattering = rate k m.scattering
      and absorption = rate k m.absorption in
      Translucent { m with scattering; absorption }
  | Emitter -> Emitter

let material k (m : Material.t) = { m with kind = material_kind k m.kind }

let used k : Scene.material -> Scene.material = function
  | Named _ as m -> m
  | Inline m -> Inline (material k m)

let rec surface k (s : Scene.surface) : Scene.surface =
  let shape : Scene.shape =
    match s.shape with
    | Sphere x -> Sphere (sphere k x)
    | Box x -> Box (box k x)
    | Triangle x -> Triangle (triangle k x)
    | Quadric x -> Quadric (quadric k x)
    | Polygon { corners; _ } ->
        Polygon (valid (Polygon.make (List.map (point k) corners)))
    | Mesh { triangles; _ } ->
        (* No file holds the new corners: it prints as what it means. *)
        let part x = Scene.plain (Triangle (triangle k x)) s.place in
        let surfaces = List.map part (Array.to_list triangles) in
        Group { transform = []; surfaces }
    | Group { transform; surfaces } ->
        Group
          {
            transform = List.map (step k) transform;
            surfaces = List.map (surface k) surfaces;
          }
    | Use { transform; name } ->
        Use { transform = List.map (step k) transform; name }
  in
  {
    s with
    shape;
    material = Option.map (used k) s.material;
    motion = Vec.scale k s.motion;
  }

let window k ({ left; right; bottom; top } : Camera.window) : Camera.window =
  { left = k *. left; right = k *. right; bottom = k *. bottom; top = k *. top }

let frame k : Camera.frame -> Camera.frame = function
  | Perspective_angle _ as f -> f
  | Perspective_window { window = w; distance } ->
      Perspective_window { window = window k w; distance = k *. distance }
  | Orthographic_height { height } ->
      Orthographic_height { height = k *. height }
  | Orthographic_window { window = w } ->
      Orthographic_window { window = window k w }
  | Panorama -> Panorama

let lens k ({ radius; focus } : Camera.lens) : Camera.lens =
  { radius = k *. radius; focus = k *. focus }

let camera k (c : Camera.t) : Camera.t =
  {
    c with
    eye = point k c.eye;
    look_at = point k c.look_at;
    frame = frame k c.frame;
    near = Option.map (fun d -> k *. d) c.near;
    lens = Option.map (lens k) c.lens;
  }

let brighter k (falloff : Light.falloff) intensity =
  match falloff with
  | Square -> Rgb.scale (k *. k) intensity
  | Constant -> intensity

let kind k : Light.kind -> Light.kind = function
  | Point { at; intensity; falloff } ->
      Point
        { at = point k at; intensity = brighter k falloff intensity; falloff }
  | Directional _ as l -> l
  | Spot s ->
      Spot
        {
          s with
          at = point k s.at;
          toward = point k s.toward;
          intensity = brighter k s.falloff s.intensity;
        }

let fog k (f : Scene.fog) =
  {
    f with
    extinction = rate k f.extinction;
    within = Option.map (bounds k) f.within;
  }

(** [by k s] is [s] with all lengths multiplied by [k], a power of two. *)
let by k (s : Scene.t) : Scene.t =
  let named f (n : _ Scene.named) = { n with value = f n.value } in
  {
    s with
    camera = camera k s.camera;
    fog =
      Option.map
        (fun (f : _ Scene.placed) -> { f with value = fog k f.value })
        s.fog;
    lights =
      List.map (fun (l : Light.t) -> { l with kind = kind k l.kind }) s.lights;
    materials = List.map (named (material k)) s.materials;
    definitions = List.map (named (List.map (surface k))) s.definitions;
    surfaces = List.map (surface k) s.surfaces;
  }

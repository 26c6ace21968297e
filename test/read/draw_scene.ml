(* Random scenes: every constructor but pictures from files, odd names, and
   numbers of every size. They make sense. *)

open Candor_space
open Candor_colour
open Candor_surface
open Candor_scene
open Candor_read
include Draw_number

(* {1 Materials, lights, cameras} *)

let rec texture ~most depth r : Texture.t =
  if depth = 0 || bool r then Constant (rgb (map (Float.mul most) share) r)
  else
    let first = texture ~most (depth - 1) r in
    let second = texture ~most (depth - 1) r in
    let scale = size r in
    if bool r then Checker { even = first; odd = second; scale }
    else Noise { first; second; scale; octaves = int 1 64 r }

let anisotropy : float draw = one_of [ const 0.; uniform (-0.99) 0.99 ]

(* With [indirect] light, colour and mirror come to at most 1. *)
let kind ~indirect r : Material.kind =
  let color = texture ~most:1. 3 r in
  let index = one_of [ const 1.; uniform 0.5 3. ] in
  match int (if indirect then 1 else 0) 8 r with
  | 0 -> Phong { color; specular = rgb share r; shininess = light_number r }
  | 1 -> Matte { color }
  | 2 -> Mirror { color }
  | 3 ->
      let most = if indirect then 0.5 else 1. in
      let mirror = rgb (map (Float.mul most) share) r in
      Glazed { color = texture ~most 3 r; mirror }
  | 4 ->
      let absorption = rgb light_number r in
      let dispersion = option size r in
      Glass { index = index r; color; absorption; dispersion }
  | 5 -> Metal { reflectance = color; roughness = share r }
  | 6 -> Plastic { color; index = index r; roughness = share r }
  | 7 ->
      let scattering = rgb light_number r in
      let absorption = rgb light_number r in
      let anisotropy = anisotropy r in
      Translucent { index = index r; scattering; absorption; anisotropy }
  | _ -> Emitter

let material ~indirect r : Material.t =
  let kind = kind ~indirect r in
  let emission = if bool r then Rgb.black else rgb light_number r in
  { kind; emission }

let falloff = one_of [ const Light.Square; const Light.Constant ]

let light r : Light.t =
  let at = point r in
  let colour = rgb light_number r in
  let kind : Light.kind =
    match int 0 2 r with
    | 0 -> Point { at; intensity = colour; falloff = falloff r }
    | 1 -> Directional { direction = direction r; irradiance = colour }
    | _ ->
        let toward = Point.v (at.x +. 1.) at.y at.z in
        let toward =
          if Point.equal at toward then Point.v 1. 2. 3. else toward
        in
        let a = uniform 0. 90. r in
        let b = uniform 0. 90. r in
        Spot
          {
            at;
            toward;
            intensity = colour;
            inner = Float.min a b;
            outer = Float.max a b;
            falloff = falloff r;
          }
  in
  { kind; shadows = bool r; place = Place.unknown }

let window r : Camera.window =
  let left = uniform (-9.) 9. r and bottom = uniform (-9.) 9. r in
  { left; right = left +. 1.5; bottom; top = bottom +. 0.1 }

let shutter r : Camera.shutter =
  let a = uniform (-1.) 1. r in
  let b = uniform (-1.) 1. r in
  one_of
    [
      const Camera.instant;
      const { Camera.opens = Float.min a b; closes = Float.max a b };
    ]
    r

let lens r : Camera.lens =
  let radius = one_of [ const 0.; size ] r in
  { radius; focus = size r }

let camera r : Camera.t =
  let eye = near_point r in
  let frame : Camera.frame =
    match int 0 4 r with
    | 0 -> Perspective_angle { fov_y = uniform 1. 179. r }
    | 1 -> Perspective_window { window = window r; distance = size r }
    | 2 -> Orthographic_height { height = size r }
    | 3 -> Orthographic_window { window = window r }
    | _ -> Panorama
  in
  let near, lens =
    match frame with
    | Perspective_angle _ | Perspective_window _ ->
        let near = option size r in
        (near, option lens r)
    | Orthographic_height _ | Orthographic_window _ -> (option size r, None)
    | Panorama -> (None, None)
  in
  {
    eye;
    look_at = Point.v (eye.x +. 1.) (eye.y -. 0.5) eye.z;
    up = Vec.v 0.1 1. (uniform 0. 1. r);
    frame;
    near;
    lens;
    shutter = shutter r;
    place = Place.unknown;
  }

(* {1 Surfaces} *)

let radii r =
  let a = size r in
  let b = size r in
  Vec.v a b (size r)

let quadric_shape r : Quadric_shape.t =
  let apex = near_point r in
  let base = Point.v apex.x (apex.y +. 1.) apex.z
  and radius = uniform 0.1 9. r in
  let center = point r in
  match int 0 9 r with
  | 0 ->
      Matrix
        [|
          1.;
          0.1;
          0.;
          0.;
          0.1;
          uniform 1. 2. r;
          0.;
          0.;
          0.;
          0.;
          1.;
          0.;
          0.;
          0.;
          0.;
          -1.;
        |]
  | 1 ->
      Form
        {
          a = [| 1.; 0.; 0.; 0.; uniform 1. 2. r; 0.; 0.; 0.; 1. |];
          b = vec r;
          c = coordinate r;
        }
  | 2 -> Plane { normal = direction r; offset = coordinate r }
  | 3 -> Ellipsoid { center; radii = radii r }
  | 4 -> Cylinder { from = apex; until = base; radius }
  | 5 -> Cone { apex; base; radius }
  | 6 -> Paraboloid { apex; base; radius }
  | 7 -> Hyperbolic_paraboloid { center; radii = radii r }
  | 8 -> Hyperboloid_one_sheet { center; radii = radii r }
  | _ -> Hyperboloid_two_sheets { center; radii = radii r }

let bounds r =
  let low = near_point r in
  Bounds.v low (Point.v (low.x +. 1.) (low.y +. 0.5) (low.z +. size r))

let uv r : Triangle.uv =
  let n () = coordinate r in
  let ua = n () in
  let va = n () in
  let ub = n () in
  let vb = n () in
  let uc = n () in
  { ua; va; ub; vb; uc; vc = n () }

let normals r =
  let a = direction r in
  let b = direction r in
  (a, b, direction r)

let polygon r =
  let z = uniform (-3.) 3. r in
  let angles =
    List.sort Float.compare (List.init (int 3 9 r) (fun _ -> uniform 0. 6. r))
  in
  Polygon.make (List.map (fun a -> Point.v (cos a) (sin a) z) angles)

let fallback =
  Scene.Box (Result.get_ok (Box.make ~min:Point.origin ~max:(Point.v 1. 1. 1.)))

let made wrap = function Ok s -> wrap s | Error (_ : string) -> fallback

let step r : Transform.step =
  let any : Transform.step =
    match int 0 3 r with
    | 0 -> Translate (vec r)
    | 1 -> Scale (vec r)
    | 2 -> Rotate { axis = direction r; degrees = uniform (-400.) 400. r }
    | _ -> Matrix { Affine.identity with xy = coordinate r; zt = coordinate r }
  in
  match Transform.of_steps [ any ] with
  | Ok _ -> any
  | Error _ -> Translate (Vec.v 1. 2. 3.)

let transform r =
  let steps = list 3 step r in
  match Transform.of_steps steps with Ok _ -> steps | Error _ -> []

let rec shape depth ~names r : Scene.shape =
  match int (if depth = 0 then 2 else 0) 6 r with
  | 0 ->
      let transform = transform r in
      Group { transform; surfaces = list 4 (surface (depth - 1) ~names) r }
  | 1 -> (
      let transform = transform r in
      match names with
      | [] -> fallback
      | _ :: _ -> Use { transform; name = one_of (List.map const names) r })
  | 2 ->
      made
        (fun s -> Scene.Sphere s)
        (Sphere.make ~center:(point r) ~radius:(size r))
  | 3 ->
      let b = bounds r in
      made
        (fun b -> Scene.Box b)
        (Box.make ~min:(Bounds.low b) ~max:(Bounds.high b))
  | 4 ->
      let a = near_point r in
      let b = near_point r in
      let corners = { Triangle.a; b; c = near_point r } in
      let normals = option normals r in
      made
        (fun t -> Scene.Triangle t)
        (Triangle.make ?normals ?uv:(option uv r) corners)
  | 5 -> (
      let shape = quadric_shape r and clip = option bounds r in
      let quadric q = Scene.Quadric q in
      match Quadric.make ?clip ~caps:(bool r) shape with
      | Ok q -> quadric q
      | Error _ -> made quadric (Quadric.make ?clip shape))
  | _ -> made (fun p -> Scene.Polygon p) (polygon r)

and surface depth ~names r : Scene.surface =
  let s = Scene.plain (shape depth ~names r) Place.unknown in
  let motion = one_of [ const Vec.zero; vec ] r in
  { s with motion; both_sides = bool r }

(* Materials by name, or their own, on some of the surfaces. Where not every
   material makes sense, one of its own that does. *)
let rec paint ~indirect ~names r (s : Scene.surface) : Scene.surface =
  let material = material ~indirect in
  let named = List.map (fun n -> const (Scene.Named n)) names in
  let inlined = map (fun m -> Scene.Inline m) material in
  let chosen = option (one_of (inlined :: named)) r in
  match s.shape with
  | Group { transform; surfaces } ->
      let surfaces = List.map (paint ~indirect ~names r) surfaces in
      { s with shape = Group { transform; surfaces }; material = chosen }
  | Use _ -> { s with material = chosen }
  | (Sphere _ | Box _ | Triangle _ | Quadric _ | Polygon _ | Mesh _) as shape ->
      let lacks = List.filter (Lack.is_of ~grouped:false shape) Lack.all in
      let own = material r in
      let suits = not (List.exists (Lack.is_minded_by own) lacks) in
      let own = if suits then own else Material.default in
      let material =
        if List.is_empty lacks then chosen else Some (Scene.Inline own)
      in
      { s with material }

(* {1 Scenes} *)

let names r = List.sort_uniq String.compare (list 4 name r)
let named value name : _ Scene.named = { name; value; place = Place.unknown }
let placed value = { Scene.value; place = Place.unknown }

let background r : Scene.background =
  let down = rgb light_number r in
  if bool r then Uniform down else Gradient { down; up = rgb light_number r }

let room r =
  let low = near_point r in
  Bounds.v low (Point.v (low.x +. 1.) (low.y +. 0.5) (low.z +. 2.))

let fog r : Scene.fog =
  let extinction = rgb light_number r in
  let albedo = rgb share r in
  let anisotropy = anisotropy r in
  { extinction; albedo; anisotropy; within = option room r }

let settings r : Scene.settings =
  {
    spp = int 1 100 r;
    depth = option (int 0 20) r;
    cutoff = share r;
    seed = (if bool r then max_int else int 0 99 r);
    filter = (if bool r then Box else Tent);
    error = option size r;
    time = option size r;
  }

let is_near (l : Light.t) =
  match l.kind with Point _ | Spot _ -> true | Directional _ -> false

(* Endless fog stands alone. *)
let cleared (s : Scene.t) =
  match s.fog with
  | Some { value = { within = None; _ }; _ } ->
      let lights = List.filter is_near s.lights in
      { s with background = Uniform Rgb.black; lights }
  | Some { value = { within = Some _; _ }; _ } | None -> s

let scene r : Scene.t =
  let material_names = names r and definition_names = names r in
  let indirect = bool r in
  let surface ~names r =
    paint ~indirect ~names:material_names r (surface 3 ~names r)
  in
  (* A definition uses those before it only. *)
  let define (before, definitions) name =
    let value = list ~least:1 3 (surface ~names:before) r in
    (name :: before, named value name :: definitions)
  in
  let _, definitions = List.fold_left define ([], []) definition_names in
  let ambient = option (map placed (rgb light_number)) r in
  cleared
    {
      width = int 1 65536 r;
      height = int 1 65536 r;
      camera = camera r;
      background = background r;
      ambient = (if indirect then None else ambient);
      indirect = (if indirect then Some Place.unknown else None);
      fog = option (map placed fog) r;
      settings = settings r;
      lights = list 4 light r;
      materials =
        List.map (fun n -> named (material ~indirect r) n) material_names;
      definitions;
      surfaces = list 6 (surface ~names:definition_names) r;
    }

let gen d = QCheck2.Gen.make_primitive ~gen:d ~shrink:(fun _ -> Seq.empty)

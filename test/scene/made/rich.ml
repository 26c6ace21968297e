(** Valid scenes drawn at random of all that the language has but pictures from
    files: what {!Drawn.scene} has, and every other material, light that
    bounces, surfaces that emit or move, fog, and what a camera can do. Paths
    are short, so that these scenes render soon. *)

open Candor_space
open Candor_colour
open Candor_scene
open Candor_read
open Candor_oracle
open QCheck2
open Gen
open Drawn

let texture =
  let noise =
    let+ first = Drawn.texture
    and+ second = Drawn.texture
    and+ scale = Draw.pick [ 0.5; 1.; 0.3 ]
    and+ octaves = int_range 1 3 in
    Texture.Noise { first; second; scale; octaves }
  in
  oneof [ Drawn.texture; Drawn.texture; noise ]

(* A colour that leaves room for another one. *)
let half = map (Rgb.scale 0.5) rgb

let rec halved : Texture.t -> Texture.t = function
  | Constant c -> Constant (Rgb.scale 0.5 c)
  | Checker c -> Checker { c with even = halved c.even; odd = halved c.odd }
  | Noise n -> Noise { n with first = halved n.first; second = halved n.second }
  | Image _ as image -> image

let index = Draw.pick [ 1.; 1.33; 1.5; 2.4; 0.75 ]
let anisotropy = Draw.pick [ 0.; 0.7; -0.5 ]

let kind : Material.kind gen =
  let* color = texture
  and* a = rgb
  and* b = rgb
  and* index = index
  and* roughness = Draw.pick [ 0.; 0.1; 0.5; 1. ]
  and* anisotropy = anisotropy
  and* dispersion = option (Draw.pick [ 20.; 60. ]) in
  Draw.pick
    [
      Material.Glass { index; color; absorption = a; dispersion };
      Metal { reflectance = color; roughness };
      Plastic { color; index; roughness };
      Translucent { index; scattering = a; absorption = b; anisotropy };
      Emitter;
    ]

(** [material ~indirect] is a material; where [indirect], one that returns no
    more light than it gets. *)
let material ~indirect =
  let+ drawn = Drawn.material
  and+ kind = kind
  and+ mirror = half
  and+ old = bool
  and+ glows = int_bound 3
  and+ bright = Draw.pick [ 0.5; 4. ]
  and+ c = rgb in
  let kind : Material.kind =
    if not old then kind
    else
      match drawn.kind with
      | Phong { color; _ } when indirect ->
          Plastic { color; index = 1.5; roughness = 0.2 }
      | Glazed { color; _ } when indirect ->
          Glazed { color = halved color; mirror }
      | ( Matte _ | Phong _ | Mirror _ | Glazed _ | Glass _ | Metal _
        | Plastic _ | Translucent _ | Emitter ) as kind ->
          kind
  in
  let emission = if glows = 0 then Rgb.scale bright c else Rgb.black in
  let emission =
    match kind with
    | Emitter -> Rgb.scale bright c
    | Matte _ | Phong _ | Mirror _ | Glazed _ | Glass _ | Metal _ | Plastic _
    | Translucent _ ->
        emission
  in
  { Material.kind; emission }

(** {1 Surfaces} *)

let motion = Draw.either 70 (pure Vec.zero) (vec Loose)

(* A surface that not every material suits has one of its own that does. *)
let rec surface ~indirect (s : Scene.surface) =
  let* shape =
    match s.shape with
    | Group { transform; surfaces = members } ->
        let+ surfaces = surfaces ~indirect members in
        Scene.Group { transform; surfaces }
    | (Sphere _ | Box _ | Triangle _ | Quadric _ | Polygon _ | Mesh _ | Use _)
      as shape ->
        pure shape
  in
  let lacks =
    List.filter (Lack.is_of ~grouped:false shape) [ Lack.Bounds; Inside ]
  in
  let+ own = material ~indirect and+ motion = motion and+ both_sides = bool in
  let suits = not (List.exists (Lack.is_minded_by own) lacks) in
  let own = if suits then own else Material.default in
  let material =
    match s.material with
    | (None | Some (Named _)) when List.is_empty lacks -> s.material
    | None | Some (Named _ | Inline _) -> Some (Scene.Inline own)
  in
  { s with shape; material; motion; both_sides }

and surfaces ~indirect list = flatten_list (List.map (surface ~indirect) list)

(** {1 The whole} *)

let camera (c : Camera.t) =
  let+ radius = Draw.pick [ 0.; 0.05; 0.3 ]
  and+ focus = Draw.uniform 2. 8.
  and+ pinhole = bool
  and+ opens = Draw.pick [ 0.; -0.5 ]
  and+ for_ = Draw.pick [ 0.; 1. ]
  and+ panorama = int_bound 5 in
  let c = { c with shutter = { opens; closes = opens +. for_ } } in
  if panorama = 0 then { c with frame = Panorama; near = None }
  else
    match c.frame with
    | Perspective_angle _ | Perspective_window _ ->
        let lens = { Camera.radius; focus } in
        { c with lens = (if pinhole then None else Some lens) }
    | Orthographic_height _ | Orthographic_window _ | Panorama -> c

let fog =
  let+ thickness = Draw.pick [ 0.02; 0.3; 2. ]
  and+ extinction = rgb
  and+ albedo = rgb
  and+ anisotropy = anisotropy
  and+ low = point Loose
  and+ size = map3 Vec.v (radius Loose) (radius Loose) (radius Loose)
  and+ endless = bool in
  let within =
    if endless then None
    else Some (Bounds.v low (Point.add low (Vec.scale 3. size)))
  in
  {
    Scene.extinction = Rgb.scale thickness extinction;
    albedo;
    anisotropy;
    within;
  }

(* Without what endless fog leaves nothing of. *)
let in_fog fog (s : Scene.t) =
  match fog with
  | Some { Scene.within = None; _ } ->
      let is_near (l : Light.t) =
        match l.kind with Point _ | Spot _ -> true | Directional _ -> false
      in
      {
        s with
        background = Uniform Rgb.black;
        lights = List.filter is_near s.lights;
      }
  | Some { within = Some _; _ } | None -> s

let deepest = 3

(* A definition may not be empty. *)
let filled = function
  | [] -> [ Scene.plain (Sphere unit_sphere) (place_of 6) ]
  | _ :: _ as surfaces -> surfaces

(** [scene style] is a {!Drawn.scene} with all of that. *)
let scene ?most style =
  let* s = Drawn.scene ?most style and* indirect = bool in
  let named value (n : _ Scene.named) =
    let+ value = value n.value in
    { n with value }
  in
  let each f list = flatten_list (List.map f list) in
  let+ materials = each (named (fun _ -> material ~indirect)) s.materials
  and+ definitions =
    each (named (fun list -> surfaces ~indirect (filled list))) s.definitions
  and+ surfaces = surfaces ~indirect s.surfaces
  and+ camera = camera s.camera
  and+ fog = Draw.either 60 (pure None) (map Option.some fog) in
  in_fog fog
    {
      s with
      camera;
      ambient = (if indirect then None else s.ambient);
      indirect = (if indirect then Some (place_of 3) else None);
      fog = Option.map (fun value -> { Scene.value; place = place_of 4 }) fog;
      settings =
        {
          s.settings with
          depth = Option.map (Int.min deepest) s.settings.depth;
        };
      materials;
      definitions;
      surfaces;
    }

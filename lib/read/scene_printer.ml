open Candor_space
open Candor_colour
open Candor_surface
open Candor_scene
open Layout

(* {1 Numbers and colours} *)

let number x = atom (Number.to_string x)
let whole n = atom (string_of_int n)
let numbers head xs = form head (List.map number xs)
let scalar head x = numbers head [ x ]
let coordinates (p : Point.t) = [ p.x; p.y; p.z ]
let components (v : Vec.t) = [ v.x; v.y; v.z ]
let point head p = numbers head (coordinates p)
let vector head v = numbers head (components v)
let tuple xs = list (List.map number xs)
let option head print = Option.fold ~none:[] ~some:(fun x -> [ print head x ])

let bounds head b =
  form head [ point "min" (Bounds.low b); point "max" (Bounds.high b) ]

(* Zeros of both signs stay apart. *)
let is_same x y = Int64.equal (Int64.bits_of_float x) (Int64.bits_of_float y)

let colour (c : Rgb.t) =
  if is_same c.r c.g && is_same c.g c.b then number c.r
  else numbers "rgb" [ c.r; c.g; c.b ]

let rgb head c = form head [ colour c ]

let rec texture (t : Texture.t) =
  match t with
  | Constant c -> colour c
  | Checker { even; odd; scale } ->
      form "checker" [ texture even; texture odd; scalar "scale" scale ]
  | Noise { first; second; scale; octaves } ->
      form "noise"
        [
          texture first;
          texture second;
          scalar "scale" scale;
          form "octaves" [ whole octaves ];
        ]
  | Image { file; _ } -> form "image" [ atom file ]

(* {1 Camera, lights, settings} *)

let window (w : Camera.window) =
  numbers "window" [ w.left; w.right; w.bottom; w.top ]

let camera (c : Camera.t) =
  let head, frame =
    match c.frame with
    | Perspective_angle { fov_y } -> ("perspective", [ scalar "fov-y" fov_y ])
    | Perspective_window { window = w; distance } ->
        ("perspective", [ window w; scalar "distance" distance ])
    | Orthographic_height { height } ->
        ("orthographic", [ scalar "height" height ])
    | Orthographic_window { window = w } -> ("orthographic", [ window w ])
    | Panorama -> ("panorama", [])
  in
  let view =
    [ point "eye" c.eye; point "look-at" c.look_at; vector "up" c.up ]
  in
  let lens =
    match c.lens with
    | None -> []
    | Some { radius; focus } ->
        [ scalar "aperture-radius" radius; scalar "focus-distance" focus ]
  in
  let shutter =
    if Camera.equal_shutter c.shutter Camera.instant then []
    else [ numbers "shutter" [ c.shutter.opens; c.shutter.closes ] ]
  in
  form "camera"
    [ form head (view @ frame @ option "near" scalar c.near @ lens @ shutter) ]

let falloff (f : Light.falloff) =
  match f with Square -> [] | Constant -> [ form "falloff" [ atom "none" ] ]

let light (l : Light.t) =
  let shadows = if l.shadows then [] else [ form "shadows" [ atom "no" ] ] in
  let kind =
    match l.kind with
    | Point { at; intensity; falloff = f } ->
        form "point"
          ([ point "at" at; rgb "intensity" intensity ] @ falloff f @ shadows)
    | Directional { direction; irradiance } ->
        form "directional"
          ([ vector "direction" direction; rgb "irradiance" irradiance ]
          @ shadows)
    | Spot { at; toward; intensity; inner; outer; falloff = f } ->
        form "spot"
          ([ point "at" at; point "toward" toward; rgb "intensity" intensity ]
          @ [ scalar "inner" inner; scalar "outer" outer ]
          @ falloff f @ shadows)
  in
  form "light" [ kind ]

let background (b : Scene.background) =
  match b with
  | Uniform c -> rgb "background" c
  | Gradient { down; up } ->
      form "background" [ form "gradient" [ rgb "down" down; rgb "up" up ] ]
  | Image { file; _ } -> form "background" [ form "image" [ atom file ] ]

let fog (f : Scene.fog Scene.placed) =
  let { Scene.extinction; albedo; anisotropy; within } = f.value in
  form "fog"
    ([ rgb "extinction" extinction; rgb "albedo" albedo ]
    @ [ scalar "anisotropy" anisotropy ]
    @ option "within" bounds within)

let settings (s : Scene.settings) =
  let filter = match s.filter with Box -> "box" | Tent -> "tent" in
  form "render"
    ([ form "spp" [ whole s.spp ] ]
    @ option "depth" (fun head n -> form head [ whole n ]) s.depth
    @ [
        scalar "cutoff" s.cutoff;
        form "seed" [ whole s.seed ];
        form "filter" [ atom filter ];
      ]
    @ option "error" scalar s.error
    @ option "time"
        (fun head t -> form head [ atom (Duration.to_string t) ])
        s.time)

(* {1 Materials} *)

let material (m : Material.t) =
  let color t = form "color" [ texture t ] in
  let emission =
    if Material.emits m then [ rgb "emission" m.emission ] else []
  in
  let form head body = Layout.form head (body @ emission) in
  match m.kind with
  | Matte { color = c } -> form "matte" [ color c ]
  | Phong { color = c; specular; shininess } ->
      form "phong"
        [ color c; rgb "specular" specular; scalar "shininess" shininess ]
  | Mirror { color = c } -> form "mirror" [ color c ]
  | Glazed { color = c; mirror } ->
      form "glazed" [ color c; rgb "mirror" mirror ]
  | Glass { index; color = c; absorption; dispersion } ->
      form "glass"
        ([ scalar "index" index; color c; rgb "absorption" absorption ]
        @ option "dispersion" scalar dispersion)
  | Metal { reflectance; roughness } ->
      form "metal"
        [
          Layout.form "reflectance" [ texture reflectance ];
          scalar "roughness" roughness;
        ]
  | Plastic { color = c; index; roughness } ->
      form "plastic"
        [ color c; scalar "index" index; scalar "roughness" roughness ]
  | Translucent { index; scattering; absorption; anisotropy } ->
      form "translucent"
        [
          scalar "index" index;
          rgb "scattering" scattering;
          rgb "absorption" absorption;
          scalar "anisotropy" anisotropy;
        ]
  | Emitter -> Layout.form "emitter" [ rgb "radiance" m.emission ]

let material_use head (m : Scene.material) =
  match m with
  | Named name -> form head [ atom name ]
  | Inline m -> form head [ material m ]

(* {1 Surfaces} *)

let triangle (t : Triangle.t) =
  let { Triangle.a; b; c } = t.corners in
  let normals head (na, nb, nc) =
    form head (List.map (fun n -> tuple (components n)) [ na; nb; nc ])
  in
  let uv head (t : Triangle.uv) =
    form head
      [ tuple [ t.ua; t.va ]; tuple [ t.ub; t.vb ]; tuple [ t.uc; t.vc ] ]
  in
  List.map (fun p -> tuple (coordinates p)) [ a; b; c ]
  @ option "normals" normals t.normals
  @ option "uv" uv t.uv

let quadric_shape (s : Quadric_shape.t) =
  let tapered head apex base radius =
    form head [ point "apex" apex; point "base" base; scalar "radius" radius ]
  in
  let centred head center radii =
    form head [ point "center" center; vector "radii" radii ]
  in
  match s with
  | Matrix q -> numbers "matrix" (Array.to_list q)
  | Form { a; b; c } ->
      form "form" [ numbers "a" (Array.to_list a); vector "b" b; scalar "c" c ]
  | Plane { normal; offset } ->
      form "plane" [ vector "normal" normal; scalar "offset" offset ]
  | Ellipsoid { center; radii } -> centred "ellipsoid" center radii
  | Cylinder { from; until; radius } ->
      form "cylinder"
        [ point "from" from; point "to" until; scalar "radius" radius ]
  | Cone { apex; base; radius } -> tapered "cone" apex base radius
  | Paraboloid { apex; base; radius } -> tapered "paraboloid" apex base radius
  | Hyperbolic_paraboloid { center; radii } ->
      centred "hyperbolic-paraboloid" center radii
  | Hyperboloid_one_sheet { center; radii } ->
      centred "hyperboloid-one-sheet" center radii
  | Hyperboloid_two_sheets { center; radii } ->
      centred "hyperboloid-two-sheets" center radii

let quadric q =
  (quadric_shape (Quadric.shape q) :: option "clip" bounds (Quadric.clip q))
  @ if Quadric.caps q then [ form "caps" [] ] else []

let step (s : Transform.step) =
  match s with
  | Translate v -> vector "translate" v
  | Scale v -> vector "scale" v
  | Rotate { axis; degrees } ->
      form "rotate" [ vector "axis" axis; scalar "degrees" degrees ]
  | Matrix m ->
      numbers "matrix"
        ([ m.xx; m.xy; m.xz; m.xt; m.yx; m.yy; m.yz; m.yt ]
        @ [ m.zx; m.zy; m.zz; m.zt ])

let transform steps =
  if List.is_empty steps then [] else [ form "transform" (List.map step steps) ]

let rec surface (s : Scene.surface) =
  let motion = if Scene.is_still s then [] else [ vector "motion" s.motion ]
  and both_sides = if s.both_sides then [ form "both-sides" [] ] else [] in
  let attributes =
    option "material" material_use s.material @ motion @ both_sides
  in
  let form head body = form head (body @ attributes) in
  match s.shape with
  | Sphere s ->
      form "sphere"
        [ point "center" (Sphere.center s); scalar "radius" s.radius ]
  | Box b ->
      let b = (b :> Bounds.t) in
      form "box" [ point "min" (Bounds.low b); point "max" (Bounds.high b) ]
  | Triangle t -> form "triangle" (triangle t)
  | Quadric q -> form "quadric" (quadric q)
  | Polygon p ->
      form "polygon" (List.map (fun p -> tuple (coordinates p)) p.corners)
  | Mesh { file; _ } -> form "mesh" [ atom file ]
  | Group { transform = steps; surfaces } ->
      form "group" (transform steps @ List.map surface surfaces)
  | Use { transform = steps; name } -> form "use" (atom name :: transform steps)

(* {1 Scenes} *)

let forms (s : Scene.t) =
  let ambient head (a : Rgb.t Scene.placed) = rgb head a.value in
  let named (m : Material.t Scene.named) =
    form "material" [ atom m.name; material m.value ]
  in
  let define (d : Scene.surface list Scene.named) =
    form "define" (atom d.name :: List.map surface d.value)
  in
  let image = form "size" [ whole s.width; whole s.height ] in
  let once =
    [ form "image" [ image ]; settings s.settings; camera s.camera ]
    @ [ background s.background ]
    @ option "ambient" ambient s.ambient
    @ option "indirect-light" (fun head _ -> form head []) s.indirect
    @ Option.fold ~none:[] ~some:(fun f -> [ fog f ]) s.fog
  in
  let each print list = Seq.map print (List.to_seq list) in
  Seq.concat
    (List.to_seq
       [
         List.to_seq once;
         each light s.lights;
         each named s.materials;
         each define s.definitions;
         each surface s.surfaces;
       ])

let to_string s =
  let b = Buffer.create 65536 in
  Buffer.add_string b "(scene";
  Seq.iter
    (fun form ->
      Buffer.add_string b "\n  ";
      Layout.add b ~indent:2 form)
    (forms s);
  Buffer.add_string b ")\n";
  Buffer.contents b

let pp ppf s = Format.pp_print_string ppf (to_string s)

(* Random scenes: every constructor, odd names, and numbers of every size. *)

open Candor_space
open Candor_colour
open Candor_surface
open Candor_scene

type 'a draw = Random.State.t -> 'a

let one_of (l : 'a draw list) : 'a draw =
 fun r -> List.nth l (Random.State.int r (List.length l)) r

let const x : 'a draw = fun _ -> x
let int low high : int draw = fun r -> low + Random.State.int r (high - low + 1)
let map f (d : 'a draw) : 'b draw = fun r -> f (d r)
let bool : bool draw = Random.State.bool

let option (d : 'a draw) : 'a option draw =
 fun r -> if bool r then Some (d r) else None

let list ?(least = 0) n (d : 'a draw) : 'a list draw =
 fun r -> List.init (int least n r) (fun _ -> d r)

(* {1 Numbers} *)

let uniform low high : float draw =
 fun r -> low +. Random.State.float r (high -. low)

let bits : float draw = map Int64.float_of_bits (fun r -> Random.State.bits64 r)

let coordinate : float draw =
 fun r ->
  let x =
    one_of
      [
        map float_of_int (int (-9) 9);
        map (fun n -> float_of_int n /. 10.) (int (-99) 99);
        uniform (-10.) 10.;
        bits;
        const (-0.);
        const 0x1p-1074;
      ]
      r
  in
  if Reach.length x then x else 1.

let size : float draw =
 fun r ->
  let x = Float.abs (coordinate r) in
  if x >= 0x1p-400 && x <= 0x1p400 then x else 0.5

let share = one_of [ const 0.; const 1.; const 0.1; uniform 0. 1. ]

let light_number : float draw =
 fun r ->
  let x = Float.abs (bits r) in
  if Float.is_finite x then x else 3.

let point r =
  let x = coordinate r in
  let y = coordinate r in
  Point.v x y (coordinate r)

let vec r = Point.sub (point r) Point.origin

let direction r =
  let v = vec r in
  if Vec.equal v Vec.zero then Vec.v 0. 0. 1. else v

let near_point r =
  let x = uniform (-9.) 9. r in
  let y = uniform (-9.) 9. r in
  Point.v x y (uniform (-9.) 9. r)

let rgb d r =
  let a = d r in
  if bool r then Rgb.grey a
  else
    let b = d r in
    Rgb.v a b (d r)

let name : string draw =
  one_of
    [
      (fun r -> Printf.sprintf "name%d" (int 0 999 r));
      (fun r -> String.init (int 0 5 r) (fun _ -> Char.chr (int 1 255 r)));
      one_of
        (List.map const
           [
             "";
             "(";
             "a b";
             "\"q\"";
             ";x";
             "#|";
             "|#";
             "\\";
             "5";
             "scene";
             "#;";
             "a\nb";
             "\xc3\xa4";
           ]);
    ]

(* {1 Materials, lights, cameras} *)

let rec texture depth r : Texture.t =
  if depth = 0 || bool r then Constant (rgb share r)
  else
    let even = texture (depth - 1) r in
    let odd = texture (depth - 1) r in
    Checker { even; odd; scale = size r }

let material r : Material.t =
  let color = texture 3 r in
  match int 0 3 r with
  | 0 -> Matte { color }
  | 1 -> Phong { color; specular = rgb share r; shininess = light_number r }
  | 2 -> Mirror { color }
  | _ -> Glazed { color; mirror = rgb share r }

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

let camera r : Camera.t =
  let eye = near_point r in
  let frame : Camera.frame =
    match int 0 3 r with
    | 0 -> Perspective_angle { fov_y = uniform 1. 179. r }
    | 1 -> Perspective_window { window = window r; distance = size r }
    | 2 -> Orthographic_height { height = size r }
    | _ -> Orthographic_window { window = window r }
  in
  {
    eye;
    look_at = Point.v (eye.x +. 1.) (eye.y -. 0.5) eye.z;
    up = Vec.v 0.1 1. (uniform 0. 1. r);
    frame;
    near = option size r;
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
  { shape = shape depth ~names r; material = None; place = Place.unknown }

(* Materials by name, or their own, on some of the surfaces. *)
let rec paint ~names r (s : Scene.surface) : Scene.surface =
  let named = List.map (fun n -> const (Scene.Named n)) names in
  let inlined = map (fun m -> Scene.Inline m) material in
  let material = option (one_of (inlined :: named)) r in
  match s.shape with
  | Group { transform; surfaces } ->
      let surfaces = List.map (paint ~names r) surfaces in
      { s with shape = Group { transform; surfaces }; material }
  | Sphere _ | Box _ | Triangle _ | Quadric _ | Polygon _ | Use _ ->
      { s with material }

(* {1 Scenes} *)

let names r = List.sort_uniq String.compare (list 4 name r)
let named value name : _ Scene.named = { name; value; place = Place.unknown }

let scene r : Scene.t =
  let material_names = names r and definition_names = names r in
  let surface ~names r = paint ~names:material_names r (surface 3 ~names r) in
  (* A definition uses those before it only. *)
  let define (before, definitions) name =
    let value = list ~least:1 3 (surface ~names:before) r in
    (name :: before, named value name :: definitions)
  in
  let _, definitions = List.fold_left define ([], []) definition_names in
  {
    width = int 1 65536 r;
    height = int 1 65536 r;
    camera = camera r;
    background =
      (if bool r then Uniform (rgb light_number r)
       else
         let down = rgb light_number r in
         Gradient { down; up = rgb light_number r });
    ambient =
      option
        (map
           (fun value -> { Scene.value; place = Place.unknown })
           (rgb light_number))
        r;
    settings =
      {
        spp = int 1 100 r;
        depth = int 0 20 r;
        cutoff = share r;
        seed = (if bool r then max_int else int 0 99 r);
        filter = (if bool r then Box else Tent);
      };
    lights = list 4 light r;
    materials = List.map (fun n -> named (material r) n) material_names;
    definitions;
    surfaces = list 6 (surface ~names:definition_names) r;
  }

let gen d = QCheck2.Gen.make_primitive ~gen:d ~shrink:(fun _ -> Seq.empty)

(** Lights and scenes for tests, made by hand. *)

open Candor_space
open Candor_colour
open Candor_surface
open Candor_scene

let valid = function Ok x -> x | Error why -> Alcotest.fail why
let p = Point.v
let dir x y z = Dir.of_vec_or Dir.z (Vec.v x y z)
let sphere center radius = valid (Sphere.make ~center ~radius)
let box min max = valid (Box.make ~min ~max)
let triangle a b c = valid (Triangle.make { Triangle.a; b; c })
let quadric ?clip ?caps shape = valid (Quadric.make ?clip ?caps shape)
let transform steps = valid (Transform.of_steps steps)
let glow k = { Material.kind = Emitter; emission = Rgb.grey k }
let matte = Material.v (Matte { color = Constant (Rgb.grey 0.5) })

let glass =
  Material.v
    (Glass
       {
         index = 1.5;
         color = Constant Rgb.white;
         absorption = Rgb.black;
         dispersion = None;
       })

(** [emitter shape] is a light of radiance 1. *)
let emitter ?transform ?(both_sides = false) shape : Primitives.t =
  {
    shape;
    transform;
    velocity = Vec.zero;
    material = glow 1.;
    both_sides;
    path = [ 0 ];
    place = Place.unknown;
  }

let camera eye look_at =
  {
    Camera.eye;
    look_at;
    up = Vec.v 0. 1. 0.;
    frame = Perspective_angle { fov_y = 40. };
    near = None;
    lens = None;
    shutter = { opens = 0.; closes = 1. };
    place = Place.unknown;
  }

let scene ?(camera = camera (p 0. 0. 9.) Point.origin) surfaces =
  {
    Scene.width = 1;
    height = 1;
    camera;
    background = Uniform Rgb.black;
    ambient = None;
    indirect = None;
    fog = None;
    settings = Scene.default_settings;
    lights = [];
    materials = [];
    definitions = [];
    surfaces;
  }

(** [made material shape] is a surface of that material. *)
let made material shape =
  { (Scene.plain shape Place.unknown) with material = Some (Inline material) }

(** [ball material center radius] is a sphere. *)
let ball material center radius = made material (Sphere (sphere center radius))

(** [moved transform surfaces] is a group. *)
let moved transform surfaces =
  Scene.plain (Group { transform; surfaces }) Place.unknown

(** smallpt's scene without its two balls: the light is a sphere that pokes
    through the ceiling. After K. Beason, smallpt, 2010. *)
let smallpt =
  let far = 1e5 in
  let wall = ball matte in
  scene
    ~camera:
      {
        (camera (p 50. 52. 295.6) (p 50. (52. -. 0.042612) 294.6)) with
        near = Some 140.;
      }
    [
      wall (p (far +. 1.) 40.8 81.6) far;
      wall (p (99. -. far) 40.8 81.6) far;
      wall (p 50. 40.8 far) far;
      wall (p 50. 40.8 (170. -. far)) far;
      wall (p 50. far 81.6) far;
      wall (p 50. (81.6 -. far) 81.6) far;
      ball (glow 12.) (p 50. (681.6 -. 0.27) 81.6) 600.;
    ]

(** [bits x] is every bit of [x]. *)
let bits = Int64.bits_of_float

let same_bits a b = Int64.equal (bits a) (bits b)

let same_dir (a : Dir.t) (b : Dir.t) =
  let a = (a :> Vec.t) and b = (b :> Vec.t) in
  same_bits a.x b.x && same_bits a.y b.y && same_bits a.z b.z

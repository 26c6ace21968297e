open Candor_oracle
open Candor_colour
open Candor_scene
open Candor_effect
open Candor_image
open Candor_scene_made

let law ?(count = 200) name f =
  Law.law ~count ~print:Drawn.show name (Drawn.scene Round) f

let rich_law ?(count = 200) name f =
  Law.law ~count ~print:Drawn.show name (Rich.scene Round) f

(* Shrinking would move surfaces onto each other. *)
let loose_law name f =
  let scenes = QCheck2.Gen.no_shrink (Drawn.scene Loose) in
  Law.law ~count:200 ~print:Drawn.show name scenes f

let all_effects s =
  Shot.same (Shot.picture s) (Shot.picture ~plan:(Plan.all s) s)

let repeated s = Shot.same (Shot.picture s) (Shot.picture s)

let scaled (s, k) =
  Shot.same (Shot.picture s) (Shot.picture (Scaled.by (Float.ldexp 1. k) s))

(* Light is never negative. *)
let non_negative (s : Scene.t) =
  let p = Shot.picture s in
  List.for_all
    (fun i ->
      let { Rgb.r; g; b } = Picture.pixel p (i mod s.width) (i / s.width) in
      r >= 0. && g >= 0. && b >= 0.)
    (List.init (s.width * s.height) Fun.id)

(* Surfaces that may emit keep their order among themselves: the others are
   shuffled around them. *)
let rec shuffled ~emits state surfaces =
  let inner (s : Scene.surface) =
    match s.shape with
    | Group g ->
        {
          s with
          shape = Group { g with surfaces = shuffled ~emits state g.surfaces };
        }
    | Sphere _ | Box _ | Triangle _ | Quadric _ | Polygon _ | Mesh _ | Use _ ->
        s
  in
  let mixed =
    List.map (fun s -> (Random.State.bits state, inner s)) surfaces
    |> List.sort (fun (a, _) (b, _) -> Int.compare a b)
    |> List.map snd
  in
  let rec refill emitting = function
    | [] -> []
    | s :: rest when emits s -> (
        match emitting with
        | first :: others -> first :: refill others rest
        | [] -> s :: refill [] rest)
    | s :: rest -> s :: refill emitting rest
  in
  refill (List.filter emits (List.map inner surfaces)) mixed

(* Whether a surface may emit: groups and uses may always. *)
let may_emit (scene : Scene.t) (s : Scene.surface) =
  let material : Scene.material -> bool = function
    | Inline m -> Material.emits m
    | Named n ->
        List.exists
          (fun (m : _ Scene.named) -> m.name = n && Material.emits m.value)
          scene.materials
  in
  match (s.shape, s.material) with
  | (Group _ | Use _), _ -> true
  | (Sphere _ | Box _ | Triangle _ | Quadric _ | Polygon _ | Mesh _), Some m ->
      material m
  | (Sphere _ | Box _ | Triangle _ | Quadric _ | Polygon _ | Mesh _), None ->
      true

let any_order ~emits (s : Scene.t) =
  let shuffled = shuffled ~emits:(emits s) in
  let state = Random.State.make [| List.length s.surfaces |] in
  let again =
    {
      s with
      surfaces = shuffled state s.surfaces;
      definitions =
        List.map
          (fun (d : _ Scene.named) -> { d with value = shuffled state d.value })
          s.definitions;
    }
  in
  Shot.same (Shot.picture s) (Shot.picture again)

let close (a : Rgb.t) (b : Rgb.t) =
  let near x y = Float.abs (x -. y) <= 1e-12 *. Float.max 1. (Float.abs x) in
  near a.r b.r && near a.g b.g && near a.b b.b

(* Each light alone on black, without ambient light; a sky alone. *)
let sum_of_lights (s : Scene.t) =
  let bare =
    {
      s with
      background = Uniform Rgb.black;
      ambient = None;
      settings = { s.settings with spp = 1; cutoff = 0. };
    }
  in
  let alone =
    List.map (fun l -> Shot.picture { bare with lights = [ l ] }) s.lights
  in
  let together = Shot.picture bare in
  List.for_all
    (fun i ->
      let at p = Picture.pixel p (i mod s.width) (i / s.width) in
      close (at together)
        (List.fold_left (fun sum p -> Rgb.add sum (at p)) Rgb.black alone))
    (List.init (s.width * s.height) Fun.id)

(* Moving a group's transform into a definition, and naming materials, changes no
   bit: they are the same surfaces. *)
let inlined (s : Scene.t) =
  let material (m : Scene.material) : Scene.material =
    match m with
    | Inline _ -> m
    | Named n -> (
        match
          List.find_opt (fun (x : _ Scene.named) -> x.name = n) s.materials
        with
        | Some x -> Inline x.value
        | None -> m)
  in
  let rec surface (x : Scene.surface) : Scene.surface =
    let shape : Scene.shape =
      match x.shape with
      | Group g -> Group { g with surfaces = List.map surface g.surfaces }
      | Use { transform; name } ->
          let d =
            List.find (fun (d : _ Scene.named) -> d.name = name) s.definitions
          in
          Group { transform; surfaces = List.map surface d.value }
      | (Sphere _ | Box _ | Triangle _ | Quadric _ | Polygon _ | Mesh _) as
        shape ->
          shape
    in
    { x with shape; material = Option.map material x.material }
  in
  Shot.same (Shot.picture s)
    (Shot.picture
       {
         s with
         surfaces = List.map surface s.surfaces;
         definitions = [];
         materials = [];
       })

let brighter k (s : Scene.t) =
  let kind (k' : Light.kind) : Light.kind =
    match k' with
    | Point p -> Point { p with intensity = Rgb.scale k p.intensity }
    | Spot p -> Spot { p with intensity = Rgb.scale k p.intensity }
    | Directional d ->
        Directional { d with irradiance = Rgb.scale k d.irradiance }
  in
  let background : Scene.background =
    match s.background with
    | Uniform c -> Uniform (Rgb.scale k c)
    | Gradient { down; up } ->
        Gradient { down = Rgb.scale k down; up = Rgb.scale k up }
    | Image _ as picture -> picture
  in
  {
    s with
    background;
    lights =
      List.map (fun (l : Light.t) -> { l with kind = kind l.kind }) s.lights;
    ambient =
      Option.map
        (fun (a : Rgb.t Scene.placed) -> { a with value = Rgb.scale k a.value })
        s.ambient;
  }

(* All light times a power of two makes the picture as much brighter; what is so
   dark that doubles lose its bits is left out. *)
let linear (s : Scene.t) =
  let plain k p =
    let part x = if k *. x < 0x1p-900 then 0. else k *. x in
    Picture.init ~width:s.width ~height:s.height (fun x y ->
        let { Rgb.r; g; b } = Picture.pixel p x y in
        Rgb.v (part r) (part g) (part b))
  in
  Shot.same
    (plain 8. (Shot.picture s))
    (plain 1. (Shot.picture (brighter 8. s)))

let with_cutoff_zero f (s : Scene.t) =
  f { s with Scene.settings = { s.settings with cutoff = 0. } }

(* Deeper paths only add light, and none where none was cut. *)
let deeper (s : Scene.t) =
  let at depth =
    Shot.v { s with settings = { s.settings with depth = Some depth } }
  in
  let a = at (Scene.depth s) and b = at (Scene.depth s + 1) in
  let { Scene.width; height; _ } = s in
  List.for_all
    (fun i ->
      let x = i mod width and y = i / width in
      let p = Picture.pixel a.picture x y and q = Picture.pixel b.picture x y in
      p.r <= q.r && p.g <= q.g && p.b <= q.b)
    (List.init (width * height) Fun.id)
  && (Tally.get a.tally Cut_by_depth > 0 || Picture.equal a.picture b.picture)

(* Laws about scenes in which nothing happens would say nothing. *)
let busy () =
  let rand = Random.State.make [| 7 |] in
  let scenes = QCheck2.Gen.generate ~rand ~n:200 (Drawn.scene Round) in
  let tally = Tally.sum (List.map (fun s -> (Shot.v s).tally) scenes) in
  let share a b =
    float_of_int (Tally.get tally a) /. float_of_int (Tally.get tally b)
  in
  let at_least name least x =
    if x < least then Alcotest.failf "%s: only %g" name x
  in
  at_least "mirror rays" 0.05 (share Mirror_rays Camera_rays);
  at_least "shadow rays" 0.05 (share Shadow_rays Camera_rays);
  at_least "paths cut by depth" 0.01 (share Cut_by_depth Camera_rays);
  if Tally.get tally Cut_by_weight = 0 then Alcotest.fail "none cut by weight"

let suite =
  ( "laws of pictures",
    [
      Law.example "the scenes drawn here are busy" busy;
      law "all effects on give the same bits" all_effects;
      rich_law ~count:1000 "all effects on give the same bits, of any scene"
        all_effects;
      law ~count:50 "a picture is the same every time" repeated;
      Law.law ~count:300
        ~print:(fun (s, k) -> Printf.sprintf "%s\n2^%d" (Drawn.show s) k)
        "a scene 2^-60 to 2^60 times as large gives the same bits"
        (QCheck2.Gen.pair (Drawn.scene Round) (QCheck2.Gen.int_range (-60) 60))
        scaled;
      Law.law ~count:200
        ~print:(fun (s, k) -> Printf.sprintf "%s\n2^%d" (Drawn.show s) k)
        "any scene 2^-60 to 2^60 times as large gives the same bits"
        (QCheck2.Gen.pair (Rich.scene Round) (QCheck2.Gen.int_range (-60) 60))
        scaled;
      rich_law ~count:100 "any picture is the same every time" repeated;
      rich_law "light of any scene is never negative" non_negative;
      loose_law "surfaces in another order give the same bits"
        (any_order ~emits:(fun _ _ -> false));
      Law.law ~count:300 ~print:Drawn.show
        "surfaces in another order give the same bits, of any scene whose \
         emitters keep theirs"
        (QCheck2.Gen.no_shrink (Rich.scene Loose))
        (any_order ~emits:may_emit);
      law "definitions and names give the bits of what they stand for" inlined;
      law "the light of several lights is the sum of theirs" sum_of_lights;
      law "8 times the light is 8 times as bright, to the bit"
        (with_cutoff_zero linear);
      law "deeper paths only add, and nothing where none was cut"
        (with_cutoff_zero deeper);
      law "light is never negative" non_negative;
    ] )

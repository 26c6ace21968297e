open Candor_space
open Candor_colour
open Candor_surface
open Candor_scene
open Candor_effect
open Candor_trace
open Candor_oracle
open Candor_scene_made
open QCheck2

(* A camera ray of a drawn scene and what it meets, if it does. *)
type case = { scene : Scene.t; ray : Ray.t; hit : Tracer.hit option }

let case =
  let open Gen in
  let* scene = Drawn.scene Round in
  let+ x = int_bound (scene.Scene.width - 1)
  and+ y = int_bound (scene.Scene.height - 1) in
  let pixel = Pixel.compile scene in
  let ray = Pixel.ray pixel ~x ~y ~sample:0 in
  { scene; ray; hit = Surface.nearest (Pixel.surface pixel) ray }

let print { scene; ray; _ } = Draw.show_ray ray ^ "\n" ^ Drawn.show scene

(* Every term there is, of effects that are on and off. *)
let terms s = (Plan.compile (Plan.all s) s (Candor_optics.Skin.surface s)).terms

let law name holds =
  Law.law ~count:1000 ~print name case (fun c ->
      match c.hit with
      | None -> true
      | Some hit ->
          let vertex = Lit.vertex hit (Vec.neg c.ray.direction) in
          List.for_all (fun (e, term) -> holds c e term vertex) (terms c.scene))

(* A recursion that answers [radiance], and what it was asked. *)
let answering radiance =
  let asked = ref [] in
  let recursion tally ~kind path ray =
    asked := (tally, kind, path, ray) :: !asked;
    radiance
  in
  (recursion, asked)

let seen = Rgb.v 0.75 2. 0.3

let black_where_off c e (term : Term.t) vertex =
  Plan.is_on (Plan.of_scene c.scene) e
  ||
  let recursion, asked = answering seen in
  Rgb.is_black (term recursion (Tally.make ()) vertex) && !asked = []

(* Only a mirror asks, once, for what comes along a ray that leaves the hit. *)
let asks _ e (term : Term.t) (vertex : Term.vertex) =
  let recursion, asked = answering seen in
  let tally = Tally.make () in
  ignore (term recursion tally vertex : Rgb.t);
  match (!asked, (e : Effect.t)) with
  | [], _ -> Tally.get tally Mirror_rays = 0
  | [ (tally', kind, path, ray) ], Mirror ->
      tally' == tally
      && Tally.get tally Mirror_rays = 1
      && String.equal kind (Effect.name e)
      && path.Path.depth = vertex.path.depth + 1
      && ray.Ray.departure <> Nowhere
      && Vec.dot (vertex.hit.normal :> Vec.t) ray.direction > 0.
  | _ :: _, _ -> false

(* The answer is all that a term takes from the recursion: twice as much light
   adds twice as much, exactly. *)
let in_proportion _ _ (term : Term.t) vertex =
  let of_light k =
    let recursion, asked = answering (Rgb.scale k seen) in
    let value = term recursion (Tally.make ()) vertex in
    (value, List.length !asked)
  in
  let once, asked = of_light 1. and twice, asked' = of_light 2. in
  asked = asked'
  && Rgb.equal twice (if asked = 0 then once else Rgb.scale 2. once)

let again _ _ (term : Term.t) vertex =
  let value () = term (fst (answering seen)) (Tally.make ()) vertex in
  Rgb.equal (value ()) (value ())

let positive _ _ (term : Term.t) vertex =
  let value = term (fst (answering seen)) (Tally.make ()) vertex in
  value.r >= 0. && value.g >= 0. && value.b >= 0.

(* A term of one's own is handed the same recursion as any other. *)
let own () =
  let twice : Term.t =
   fun radiance tally { hit; view; path; _ } ->
    Rgb.scale 2. (radiance tally ~kind:"probe" path (Hit.spawn hit view))
  in
  let s = Lit.scene [ "(sphere (center 0 0 0) (radius 1))" ] in
  let hit = Lit.hit s (0., 0., 5.) (0., 0., -1.) in
  let path = { Path.start with throughput = Rgb.grey 0.5; depth = 3 } in
  let recursion, asked = answering seen in
  let tally = Tally.make () in
  Alcotest.check Lit.rgb "twice" (Rgb.scale 2. seen)
    (twice recursion tally (Lit.vertex ~path hit (Vec.v 0. 0. 1.)));
  match !asked with
  | [ (tally', kind, path', ray) ] ->
      Alcotest.(check bool) "tally" true (tally == tally');
      Alcotest.(check string) "kind" "probe" kind;
      Alcotest.(check int) "depth" 3 path'.Path.depth;
      Alcotest.check Lit.rgb "throughput" (Rgb.grey 0.5) path'.throughput;
      Alcotest.(check bool)
        "back to the eye" true
        (Vec.equal ray.Ray.direction (Vec.v 0. 0. 1.))
  | _ -> Alcotest.fail "expected one ray"

let suite =
  ( "terms",
    [
      Law.example "a term gets the recursion that it is handed" own;
      law "a term is black where its effect is absent" black_where_off;
      law "a mirror asks for one ray that leaves the surface, others for none"
        asks;
      law "a term is in proportion to what it asks for" in_proportion;
      law "a term finds the same again" again;
      law "a term never takes light away" positive;
    ] )

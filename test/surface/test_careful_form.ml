open Candor_space
open Candor_surface
open Candor_oracle
open Candor_surface_families
open QCheck2

let answer meet q (ray : Ray.t) =
  let cursor = Cursor.v infinity in
  let contact = meet (Quadric.body q) (Object_ray.of_ray ray) cursor in
  if Contact.is_none contact then None
  else
    Some
      {
        Crossing.t = cursor.t;
        side = Contact.side contact;
        part = Contact.part contact;
      }

(* Without disks, which have a kernel of their own. *)
let cases =
  let open_ended (c : Quadric.t Family.case) = not (Quadric.caps c.shape) in
  let families =
    Quadrics.[ k1; k2; k3; k4; k5; k6; k7; k8; whole; random; simply; clipped ]
  in
  Gen.oneof (List.map (fun (f : _ Family.t) -> f.cases) families)
  |> Gen.map (fun c -> if open_ended c then Some c else None)

let right meet = function
  | None -> true
  | Some c -> (
      let kind = { Quadrics.kind with answer = answer meet } in
      let _, _, verdict = Family.judged kind ~ulps:6. c in
      match verdict with
      | Agrees | Excused -> true
      | v -> Law.fail "%s" (Crossing.show_verdict v))

let print = Option.fold ~none:"" ~some:(Family.show Quadrics.kind)

(* A ray along -x from a point of the unit sphere, which it leaves inwards. *)
let unit_sphere =
  let open Made in
  quadric (Ellipsoid { center = Point.origin; radii = v 1. 1. 1. })

let again meet side =
  let cursor = Cursor.v infinity in
  let ray = Object_ray.v (Made.p 0.6 0.8 0.) (Vec.v (-1.) 0. 0.) in
  let c : Contact.t = meet (Quadric.body unit_sphere) ray side cursor in
  (cursor.t, Contact.is_none c)

let leaves meet () =
  let check what wanted got =
    Alcotest.(check (pair (float 1e-15) bool)) what wanted got
  in
  check "inwards, to the far side" (1.2, false) (again meet Side.Inside);
  check "outwards, never again" (infinity, true) (again meet Side.Outside)

let suite =
  ( "quadrics in twice the precision",
    [
      Law.law ~count:20000 ~print "alone decide every family" cases
        (right Careful_form.meet);
      Law.example "a ray that leaves has its root at 0 taken out"
        (leaves Careful_form.meet_again);
    ] )

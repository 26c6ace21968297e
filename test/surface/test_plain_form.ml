open Candor_surface
open Candor_oracle
open Test_careful_form

(* Far from every difficulty plain doubles are enough. *)
let plainly () =
  let cursor = Cursor.v infinity in
  let ray =
    Candor_space.(Object_ray.v (Point.v 3. 0.1 0.2) (Vec.v (-1.) 0. 0.))
  in
  let contact = Plain_form.meet (Quadric.body unit_sphere) ray cursor in
  Alcotest.(check bool) "met" false (Contact.is_none contact);
  Alcotest.(check (float 0.)) "in plain doubles" 0. cursor.careful

let grazing () =
  let cursor = Cursor.v infinity in
  let ray =
    Candor_space.(Object_ray.v (Point.v 3. 1. 0.) (Vec.v (-1.) 0. 0.))
  in
  let contact = Plain_form.meet (Quadric.body unit_sphere) ray cursor in
  Alcotest.(check bool) "met" false (Contact.is_none contact);
  Alcotest.(check (float 0.)) "with care" 1. cursor.careful

let suite =
  ( "quadrics in plain doubles",
    [
      Law.law ~count:20000 ~print "decide every family, or ask for more" cases
        (right Plain_form.meet);
      Law.example "an ordinary hit needs no more" plainly;
      Law.example "a tangent does" grazing;
      Law.example "a ray that leaves has its root at 0 taken out"
        (leaves Plain_form.meet_again);
    ] )

open Candor_space
open Candor_surface
open Candor_surface_families

(* The plane z = 0 where x <= 1, and the ray that meets it at x. *)
let half_plane =
  Quadric.body
    (Made.quadric
       ~clip:
         (Bounds.v
            (Point.v (-0x1p60) (-0x1p60) (-0x1p60))
            (Point.v 1. 0x1p60 0x1p60))
       (Plane { normal = Vec.v 0. 0. 1.; offset = 0. }))

let ray x = Object_ray.v (Point.v x 0. 1.) (Vec.v 0. 0. (-1.))

let within x =
  Piece.within_cuts half_plane (ray x) 1. (Of_form { falling = true })

let cuts () =
  let check what wanted got = Alcotest.(check bool) what wanted got in
  check "inside" true (within 0. ~except:(-1));
  check "on the edge" true (within 1. ~except:(-1));
  check "an ulp beyond" false (within (Float.succ 1.) ~except:(-1));
  check "but that cut left out" true (within (Float.succ 1.) ~except:1)

let considers () =
  let ask limit t =
    let cursor = Cursor.v limit in
    let c = Piece.consider half_plane (ray 0.) t (-1.) Root.First cursor in
    (Contact.is_none c, cursor.t)
  in
  let check = Alcotest.(check (pair bool (float 0.))) in
  check "taken" (false, 1.) (ask infinity 1.);
  check "beyond the cursor" (true, 0.5) (ask 0.5 1.);
  check "not ahead" (true, infinity) (ask infinity 0.)

let keeps_the_last () =
  let a = Contact.v ~part:0 Outside and b = Contact.v ~part:1 Inside in
  Alcotest.(check bool) "the last" true (Piece.later a b = b);
  Alcotest.(check bool) "none" true (Piece.later a Contact.none = a)

let suite =
  ( "pieces of quadrics",
    Candor_oracle.Law.
      [
        example "cuts are closed, and decided to the ulp" cuts;
        example "a root is taken within the cursor only" considers;
        example "of two contacts the last that is one counts" keeps_the_last;
      ] )

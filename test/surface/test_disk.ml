open Candor_space
open Candor_surface
open Candor_surface_families

(* A cylinder of radius 1 from z = 0 to z = 2, closed: disk 0 at z = 2. *)
let can =
  Quadric.body
    (Made.quadric ~caps:true
       (Cylinder { from = Point.origin; until = Point.v 0. 0. 2.; radius = 1. }))

let meet ?(left = Contact.none) x dz =
  let cursor = Cursor.v infinity in
  let z = if dz < 0. then 5. else 1. in
  let ray = Object_ray.v (Point.v x 0. z) (Vec.v 0. 0. dz) in
  let c = Disk.meet can ray 0 left cursor in
  if Contact.is_none c then None
  else Some (cursor.t, Contact.part c, Contact.side c)

let hit = function
  | None -> "none"
  | Some (t, part, side) -> Printf.sprintf "%g %d %s" t part (Side.show side)

let check what wanted got = Alcotest.(check string) what (hit wanted) (hit got)

let meets () =
  check "from above" (Some (3., 1, Side.Outside)) (meet 0. (-1.));
  check "from within" (Some (1., 1, Side.Inside)) (meet 0. 1.);
  check "at the rim" (Some (3., 1, Side.Outside)) (meet 1. (-1.));
  check "an ulp beside it" None (meet (Float.succ 1.) (-1.))

let leaves () =
  check "never again" None (meet ~left:(Contact.v ~part:1 Inside) 0. (-1.));
  check "but from elsewhere"
    (Some (3., 1, Side.Outside))
    (meet ~left:(Contact.v ~part:0 Outside) 0. (-1.))

let suite =
  ( "disks",
    Candor_oracle.Law.
      [
        example "are met within their rim, exactly" meets;
        example "are not met by a ray that left them" leaves;
      ] )

open Candor_space
open Candor_surface
open Candor_oracle

let low_half =
  { Half_space.nx = 1.; ny = 0.; nz = 0.; px = 0.; py = 0.; pz = 0.; c = 0. }

let unit_sphere =
  Form.of_shape (Ellipsoid { center = Point.origin; radii = Vec.v 1. 1. 1. })

(* The half of the unit sphere where x <= 0, closed by a disk or not. *)
let half ~closed =
  Cut_form.make unit_sphere ~cuts:[| low_half |]
    ~disks:(if closed then [| 0 |] else [||])

let meet q o d left =
  let cursor = Cursor.v infinity in
  let contact = Cut_form.meet q (Object_ray.v o d) left cursor in
  (cursor.t, contact)

let from_above = (Point.v 5. 0.25 0., Vec.v (-1.) 0. 0.)
let contact part side = Contact.v ~part side

let check_meeting what (t, c) (o, d) left q =
  let t', c' = meet q o d left in
  Alcotest.(check (float 1e-15)) (what ^ ": t") t t';
  Alcotest.(check int) (what ^ ": contact") (c : Contact.t :> int) (c' :> int)

let disk () =
  check_meeting "closed"
    (5., contact 1 Outside)
    from_above Contact.none (half ~closed:true)

let no_disk () =
  check_meeting "open"
    (5. +. sqrt 0.9375, contact 0 Inside)
    from_above Contact.none (half ~closed:false)

let again () =
  let on_disk = (Point.v 0. 0.25 0., Vec.v (-1.) 0. 0.) in
  check_meeting "from the disk inwards"
    (sqrt 0.9375, contact 0 Inside)
    on_disk (contact 1 Inside) (half ~closed:true);
  let outwards = (Point.v 0. 0.25 0., Vec.v 1. 0. 0.) in
  check_meeting "from the disk outwards" (infinity, Contact.none) outwards
    (contact 1 Outside) (half ~closed:true)

let cut_off () =
  let beyond = (Point.v 5. 2. 0., Vec.v (-1.) 0. 0.) in
  check_meeting "beside the rim" (infinity, Contact.none) beyond Contact.none
    (half ~closed:true)

let suite =
  ( "polynomial cut to size",
    [
      Law.example "a disk closes the plane of its cut, within the surface" disk;
      Law.example "without the disk the ray goes on to the far side" no_disk;
      Law.example "a ray that left the disk does not meet it again" again;
      Law.example "beyond the rim there is nothing" cut_off;
    ] )

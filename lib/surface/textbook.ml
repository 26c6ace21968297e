open Candor_space

let epsilon = 0.0001

(* Of the roots near <= far: the first beyond the epsilon. *)
let[@inline] first near far (cursor : Cursor.t) =
  if near > cursor.least then
    Cursor.take cursor near (Contact.v ~part:0 Side.Outside)
  else Cursor.take cursor far (Contact.v ~part:0 Side.Inside)

let sphere (s : Sphere.t) (o : Point.t) (d : Vec.t) cursor =
  let fx = o.x -. s.x and fy = o.y -. s.y and fz = o.z -. s.z in
  let a = (d.x *. d.x) +. (d.y *. d.y) +. (d.z *. d.z) in
  let b = (fx *. d.x) +. (fy *. d.y) +. (fz *. d.z) in
  let c = (fx *. fx) +. (fy *. fy) +. (fz *. fz) -. (s.radius *. s.radius) in
  let disc = (b *. b) -. (a *. c) in
  if disc < 0. then Contact.none
  else
    let root = sqrt disc in
    first ((-.b -. root) /. a) ((-.b +. root) /. a) cursor

let[@inline] least (x : float) y = if x < y then x else y
let[@inline] greatest (x : float) y = if x > y then x else y

let box b (o : Point.t) (d : Vec.t) (cursor : Cursor.t) =
  let { Bounds.x0; y0; z0; x1; y1; z1 } = Box.bounds b in
  let ix = 1. /. d.x and iy = 1. /. d.y and iz = 1. /. d.z in
  let ax = (x0 -. o.x) *. ix and bx = (x1 -. o.x) *. ix in
  let ay = (y0 -. o.y) *. iy and by = (y1 -. o.y) *. iy in
  let az = (z0 -. o.z) *. iz and bz = (z1 -. o.z) *. iz in
  let nx = least ax bx and fx = greatest ax bx in
  let ny = least ay by and fy = greatest ay by in
  let nz = least az bz and fz = greatest az bz in
  let near = greatest nx (greatest ny nz) and far = least fx (least fy fz) in
  if near > far then Contact.none
  else
    let part axis positive high =
      (2 * axis) + if Bool.equal positive high then 1 else 0
    in
    let at axis high side =
      Contact.v ~part:(part axis (Vec.get d axis > 0.) high) side
    in
    if near > cursor.least then
      let axis = if nx = near then 0 else if ny = near then 1 else 2 in
      Cursor.take cursor near (at axis false Outside)
    else
      let axis = if fx = far then 0 else if fy = far then 1 else 2 in
      Cursor.take cursor far (at axis true Inside)

(* As published: a determinant below this counts as a ray along the plane. *)
let parallel = 0.000001

let triangle (s : Triangle.t) (o : Point.t) (d : Vec.t) cursor =
  let { Triangle.a; b; c } = s.corners in
  let px = b.x -. a.x and py = b.y -. a.y and pz = b.z -. a.z in
  let qx = c.x -. a.x and qy = c.y -. a.y and qz = c.z -. a.z in
  let hx = (d.y *. qz) -. (d.z *. qy)
  and hy = (d.z *. qx) -. (d.x *. qz)
  and hz = (d.x *. qy) -. (d.y *. qx) in
  let det = (px *. hx) +. (py *. hy) +. (pz *. hz) in
  if Float.abs det < parallel then Contact.none
  else
    let inverse = 1. /. det in
    let rx = o.x -. a.x and ry = o.y -. a.y and rz = o.z -. a.z in
    let u = ((rx *. hx) +. (ry *. hy) +. (rz *. hz)) *. inverse in
    if u < 0. || u > 1. then Contact.none
    else
      let kx = (ry *. pz) -. (rz *. py)
      and ky = (rz *. px) -. (rx *. pz)
      and kz = (rx *. py) -. (ry *. px) in
      let v = ((d.x *. kx) +. (d.y *. ky) +. (d.z *. kz)) *. inverse in
      if v < 0. || u +. v > 1. then Contact.none
      else
        let t = ((qx *. kx) +. (qy *. ky) +. (qz *. kz)) *. inverse in
        let side : Side.t = if det > 0. then Outside else Inside in
        Cursor.take cursor t (Contact.v ~part:0 side)

(* {1 Quadrics} *)

let[@inline] at (o : Point.t) (d : Vec.t) t =
  Point.v (o.x +. (t *. d.x)) (o.y +. (t *. d.y)) (o.z +. (t *. d.z))

let beyond (h : Half_space.t) (p : Point.t) =
  (h.nx *. (p.x -. h.px))
  +. (h.ny *. (p.y -. h.py))
  +. (h.nz *. (p.z -. h.pz))
  -. h.c

let within (q : Piece.t) p ~except =
  let rec all i =
    i = Array.length q.cuts
    || ((i = except || beyond q.cuts.(i) p <= 0.) && all (i + 1))
  in
  all 0

let[@inline] value (f : Form.t) (p : Point.t) =
  let x = p.x -. f.cx and y = p.y -. f.cy and z = p.z -. f.cz in
  (x *. ((f.axx *. x) +. (f.axy *. y) +. (f.axz *. z) +. (2. *. f.gx)))
  +. (y *. ((f.axy *. x) +. (f.ayy *. y) +. (f.ayz *. z) +. (2. *. f.gy)))
  +. (z *. ((f.axz *. x) +. (f.ayz *. y) +. (f.azz *. z) +. (2. *. f.gz)))
  +. f.k

let later earlier last = if Contact.is_none last then earlier else last

let root q o d t side (cursor : Cursor.t) =
  if t > cursor.least && t <= cursor.t && within q (at o d t) ~except:(-1) then
    Cursor.take cursor t (Contact.v ~part:0 side)
  else Contact.none

let form (q : Piece.t) (o : Point.t) (d : Vec.t) cursor =
  let f = q.form in
  let x = o.x -. f.cx and y = o.y -. f.cy and z = o.z -. f.cz in
  let ux = (f.axx *. d.x) +. (f.axy *. d.y) +. (f.axz *. d.z)
  and uy = (f.axy *. d.x) +. (f.ayy *. d.y) +. (f.ayz *. d.z)
  and uz = (f.axz *. d.x) +. (f.ayz *. d.y) +. (f.azz *. d.z) in
  let a = (ux *. d.x) +. (uy *. d.y) +. (uz *. d.z)
  and b =
    (ux *. x) +. (uy *. y) +. (uz *. z)
    +. ((f.gx *. d.x) +. (f.gy *. d.y) +. (f.gz *. d.z))
  and c = value f o in
  if a = 0. then
    let side : Side.t = if b < 0. then Outside else Inside in
    root q o d (-.c /. (2. *. b)) side cursor
  else
    let disc = (b *. b) -. (a *. c) in
    if disc < 0. then Contact.none
    else
      let s = sqrt disc in
      let falling = root q o d ((-.b -. s) /. a) Outside cursor in
      later falling (root q o d ((-.b +. s) /. a) Inside cursor)

let disk (q : Piece.t) (o : Point.t) (d : Vec.t) end_ (cursor : Cursor.t) =
  let h = q.cuts.(end_) in
  let speed = Vec.dot (Vec.v h.nx h.ny h.nz) d in
  let t = -.beyond h o /. speed in
  let p = at o d t in
  if
    t > cursor.least && t <= cursor.t
    && value q.form p <= 0.
    && within q p ~except:end_
  then
    let side : Side.t = if speed < 0. then Outside else Inside in
    Cursor.take cursor t (Contact.v ~part:(end_ + 1) side)
  else Contact.none

let quadric s o d cursor =
  let q = Quadric.body s in
  let add found end_ = later found (disk q o d end_ cursor) in
  Array.fold_left add (form q o d cursor) q.disks

let group m (ray : Object_ray.t) =
  let back = (Transform.backward m).high in
  Object_ray.v (Affine.point back ray.origin) (Affine.vector back ray.direction)

let moved d (ray : Object_ray.t) =
  Object_ray.v (Point.add ray.origin (Vec.neg d)) ray.direction

(* {1 What is hit} *)

let local point normal ~flat ?smooth careful =
  {
    Local.point;
    normal;
    error = Vec.zero;
    flat;
    uv = lazy (Lazy.force (careful ()).Local.uv);
    smooth;
  }

let here (ray : Object_ray.t) t = at ray.origin ray.direction t

let locate_sphere s ray t contact =
  let p = here ray t in
  let normal = Dir.of_vec_or Dir.x (Point.sub p (Sphere.center s)) in
  local p normal ~flat:false (fun () -> Sphere.locate s ray t contact)

let locate_box b ray t contact =
  let part = Contact.part contact in
  let axis = part / 2 in
  let outward = if axis = 0 then Dir.x else if axis = 1 then Dir.y else Dir.z in
  local (here ray t)
    (if part land 1 = 1 then outward else Dir.neg outward)
    ~flat:true
    (fun () -> Box.locate b ray t contact)

let locate_triangle (s : Triangle.t) ray t =
  let { Triangle.a; b; c } = s.corners in
  let careful () = Triangle.locate s ray in
  let normal =
    Dir.of_vec_or Dir.z (Vec.cross (Point.sub b a) (Point.sub c a))
  in
  let smooth = Option.bind s.normals (fun _ -> (careful ()).smooth) in
  local (here ray t) normal ~flat:true ?smooth careful

let locate_quadric q (ray : Object_ray.t) t contact =
  let p = here ray t in
  let { Piece.form; cuts; linear; _ } = Quadric.body q in
  let part = Contact.part contact in
  let outward =
    match part with
    | 0 -> Form.gradient form (Point.sub p (Form.center form))
    | part ->
        let h = cuts.(part - 1) in
        Vec.v h.nx h.ny h.nz
  in
  let normal = Dir.of_vec_or Dir.z outward in
  local p normal
    ~flat:(linear || part > 0)
    (fun () -> Quadric.locate q ray t contact)

open Candor_number
open Candor_space
open Piece

(* The roots by a, b and c taken anew with fused products, which lose half as much;
   for the few rays that hit. *)
let consider_sharply q (ray : Object_ray.t) ~a ~root cursor =
  let f = q.form and fma = Float.fma in
  let o = ray.origin and o' = ray.origin_low in
  let d = ray.direction and d' = ray.direction_low in
  let x = o.x -. f.cx and y = o.y -. f.cy and z = o.z -. f.cz in
  let x' = Error_free.sum_error o.x (-.f.cx) x +. o'.x
  and y' = Error_free.sum_error o.y (-.f.cy) y +. o'.y
  and z' = Error_free.sum_error o.z (-.f.cz) z +. o'.z in
  (* A y + g *)
  let u = fma f.axx x (fma f.axy y (fma f.axz z f.gx))
  and v = fma f.axy x (fma f.ayy y (fma f.ayz z f.gy))
  and w = fma f.axz x (fma f.ayz y (fma f.azz z f.gz)) in
  let b =
    fma u d.x (fma v d.y (fma w d.z (Error_free.dot u v w d'.x d'.y d'.z)))
  and c =
    fma x (u +. f.gx)
      (fma y (v +. f.gy)
         (fma z (w +. f.gz) (f.k +. (2. *. Error_free.dot u v w x' y' z'))))
  in
  let r = if b >= 0. then -.(b +. root) else root -. b in
  let earlier = consider q ray (c /. r) b Root.First cursor in
  let second = r /. a in
  if second > 0. && second <= cursor.Cursor.t *. (1. +. 0x1p-48) then
    let second = r /. (Form.bend f d d').hi in
    later earlier (consider q ray second b Root.Second cursor)
  else earlier

let meet_linear q (ray : Object_ray.t) cursor =
  let f = q.form and o = ray.origin and d = ray.direction in
  let abs = Float.abs in
  let fx = o.x -. f.cx and fy = o.y -. f.cy and fz = o.z -. f.cz in
  let bx = f.gx *. d.x and by = f.gy *. d.y and bz = f.gz *. d.z in
  let cx = f.gx *. fx and cy = f.gy *. fy and cz = f.gz *. fz in
  let slope = Form.slope f in
  let b = bx +. by +. bz +. Vec.dot slope ray.direction_low in
  let c = (2. *. (cx +. cy +. cz +. Vec.dot slope ray.origin_low)) +. f.k in
  let b_size = abs bx +. abs by +. abs bz in
  let c_size = (2. *. (abs cx +. abs cy +. abs cz)) +. abs f.k in
  if b_size <= 2. *. abs b && c_size <= 2. *. abs c && b_size > 0x1p-900 then
    let t = -.c /. (2. *. b) in
    if t > 0. && t <= cursor.Cursor.t then consider q ray t b Root.First cursor
    else Contact.none
  else Careful_form.meet q ray cursor

(* The second tier: plain doubles, with bounds on their errors in units of u from
   the same products of absolute values (names with a prime). Roots come from the
   ray's origin f + l, the discriminant from p, the point of the line where F has
   its extremum: there it hardly cancels. A number is accepted when its error
   is at most 2^5 u of it (that of the discriminant's root, of the sum it goes
   into), a miss when the discriminant is below its error. *)
let meet_recentred q (ray : Object_ray.t) cursor =
  let open Error_free in
  let f = q.form and abs = Float.abs in
  let o = ray.origin and d = ray.direction in
  let o' = ray.origin_low and d' = ray.direction_low in
  let dx = d.x and dy = d.y and dz = d.z in
  let fx = o.x -. f.cx and fy = o.y -. f.cy and fz = o.z -. f.cz in
  let lx = sum_error o.x (-.f.cx) fx +. o'.x
  and ly = sum_error o.y (-.f.cy) fy +. o'.y
  and lz = sum_error o.z (-.f.cz) fz +. o'.z in
  (* A d and A f + g *)
  let ux = dot f.axx f.axy f.axz dx dy dz
  and uy = dot f.axy f.ayy f.ayz dx dy dz
  and uz = dot f.axz f.ayz f.azz dx dy dz in
  let wx = dot f.axx f.axy f.axz fx fy fz +. f.gx
  and wy = dot f.axy f.ayy f.ayz fx fy fz +. f.gy
  and wz = dot f.axz f.ayz f.azz fx fy fz +. f.gz in
  let a = dot ux uy uz dx dy dz +. (2. *. dot ux uy uz d'.x d'.y d'.z) in
  let sizes =
    let dx = abs dx and dy = abs dy and dz = abs dz in
    dot
      (dot (abs f.axx) (abs f.axy) (abs f.axz) dx dy dz)
      (dot (abs f.axy) (abs f.ayy) (abs f.ayz) dx dy dz)
      (dot (abs f.axz) (abs f.ayz) (abs f.azz) dx dy dz)
      dx dy dz
  in
  (* Along a cone or a saddle a cancels for every ray of that direction. *)
  let cancels = sizes > 4. *. abs a in
  let a = if cancels then (Form.bend f d d').hi else a in
  let a' =
    if cancels then (4. *. abs a) +. (0x1p-40 *. sizes) else 8. *. sizes
  in
  let b =
    dot wx wy wz dx dy dz
    +. (dot ux uy uz lx ly lz +. dot wx wy wz d'.x d'.y d'.z)
  in
  let c =
    dot wx wy wz fx fy fz
    +. dot f.gx f.gy f.gz fx fy fz
    +. f.k
    +. (2. *. dot wx wy wz lx ly lz)
  in
  let t = -.b /. a in
  let mx = lx +. (t *. d'.x)
  and my = ly +. (t *. d'.y)
  and mz = lz +. (t *. d'.z) in
  let px = Float.fma t dx fx +. mx
  and py = Float.fma t dy fy +. my
  and pz = Float.fma t dz fz +. mz in
  let vx = dot f.axx f.axy f.axz px py pz +. f.gx
  and vy = dot f.axy f.ayy f.ayz px py pz +. f.gy
  and vz = dot f.axz f.ayz f.azz px py pz +. f.gz in
  let bp = dot vx vy vz dx dy dz +. dot vx vy vz d'.x d'.y d'.z in
  let cp = dot vx vy vz px py pz +. dot f.gx f.gy f.gz px py pz +. f.k in
  let disc = difference_of_products bp bp a cp in
  let dx = abs dx and dy = abs dy and dz = abs dz in
  let fx = abs fx +. abs lx
  and fy = abs fy +. abs ly
  and fz = abs fz +. abs lz in
  let px = abs px +. abs mx
  and py = abs py +. abs my
  and pz = abs pz +. abs mz in
  let axx = abs f.axx and ayy = abs f.ayy and azz = abs f.azz in
  let axy = abs f.axy and axz = abs f.axz and ayz = abs f.ayz in
  let gx = abs f.gx and gy = abs f.gy and gz = abs f.gz and k = abs f.k in
  let ux = dot axx axy axz dx dy dz
  and uy = dot axy ayy ayz dx dy dz
  and uz = dot axz ayz azz dx dy dz in
  let vx = dot axx axy axz px py pz +. (2. *. gx)
  and vy = dot axy ayy ayz px py pz +. (2. *. gy)
  and vz = dot axz ayz azz px py pz +. (2. *. gz) in
  let gd = dot gx gy gz dx dy dz in
  let bp' = 12. *. (dot ux uy uz px py pz +. gd) in
  let cp' = 16. *. (dot vx vy vz px py pz +. k) in
  let disc' =
    (2. *. abs bp *. bp')
    +. (abs a *. cp')
    +. (abs cp *. a')
    +. (4. *. abs disc)
    +. (0x1p-52 *. ((bp' *. bp') +. (a' *. cp')))
  in
  if not (disc' > 0x1p-800 && disc' < 0x1p900 && a' <= 0x1p5 *. abs a) then
    Careful_form.meet q ray cursor
  else if disc < -0x1p-52 *. disc' then Contact.none
  else
    let wx = dot axx axy axz fx fy fz +. (2. *. gx)
    and wy = dot axy ayy ayz fx fy fz +. (2. *. gy)
    and wz = dot axz ayz azz fx fy fz +. (2. *. gz) in
    let b' = 12. *. (dot ux uy uz fx fy fz +. gd) in
    let c' = 14. *. (dot wx wy wz fx fy fz +. k) in
    let root = sqrt disc in
    let r = if b >= 0. then -.(b +. root) else root -. b in
    if
      disc' <= 0x1p6 *. root *. abs r
      && c' <= 0x1p5 *. abs c
      && b' <= 0x1p5 *. abs r
      && abs b > 0x1p-50 *. b'
    then consider_sharply q ray ~a ~root cursor
    else Careful_form.meet q ray cursor

(* The first tier: the school formula, with coarse bounds on its errors in units
   of u from the sizes of A, g, d and y (names with a prime). It decides most of
   what is clearly missed, and most of what is met from nearby. *)
let meet_curved q (ray : Object_ray.t) cursor =
  let open Error_free in
  let f = q.form and abs = Float.abs in
  let o = ray.origin and d = ray.direction in
  let dx = d.x and dy = d.y and dz = d.z in
  let x = o.x -. f.cx and y = o.y -. f.cy and z = o.z -. f.cz in
  let ux = dot f.axx f.axy f.axz dx dy dz
  and uy = dot f.axy f.ayy f.ayz dx dy dz
  and uz = dot f.axz f.ayz f.azz dx dy dz in
  let g = dot f.gx f.gy f.gz x y z in
  let a = dot ux uy uz dx dy dz in
  let b = dot ux uy uz x y z +. dot f.gx f.gy f.gz dx dy dz in
  let c =
    dot
      (dot f.axx f.axy f.axz x y z)
      (dot f.axy f.ayy f.ayz x y z)
      (dot f.axz f.ayz f.azz x y z)
      x y z
    +. (2. *. g) +. f.k
  in
  let d2 = dot dx dy dz dx dy dz in
  let far = sqrt (dot x y z x y z) in
  let far =
    if ray.exact then far else far +. (0x1p54 *. Vec.norm1 ray.origin_low)
  in
  let b' = 16. *. sqrt d2 *. ((f.a_size *. far) +. f.g_size) in
  let c' =
    20. *. ((((f.a_size *. far) +. (2. *. f.g_size)) *. far) +. abs f.k)
  in
  let a' = 10. *. f.a_size *. d2 in
  let bb = b *. b and ac = a *. c in
  let disc = bb -. ac in
  let disc' =
    (2. *. abs b *. b')
    +. (abs a *. c')
    +. (abs c *. a')
    +. (4. *. (bb +. abs ac))
  in
  if not (disc' > 0x1p-800 && disc' < 0x1p900) then
    Careful_form.meet q ray cursor
  else if disc < -0x1p-52 *. disc' then Contact.none
  else
    let root = sqrt disc in
    let r = if b >= 0. then -.(b +. root) else root -. b in
    if
      disc' <= 0x1p5 *. root *. abs r
      && c' <= 0x1p5 *. abs c
      && b' <= 0x1p5 *. abs r
      && a' <= 0x1p5 *. abs a
      && abs b > 0x1p-50 *. b'
    then consider_sharply q ray ~a ~root cursor
    else meet_recentred q ray cursor

let meet q ray cursor =
  if q.linear then meet_linear q ray cursor else meet_curved q ray cursor

(* Most often the sign of a alone tells that nothing is ahead, or a and b are
   known well enough, in the sense of the second tier. *)
let meet_again q (ray : Object_ray.t) side cursor =
  let open Error_free in
  let f = q.form and abs = Float.abs in
  let o = ray.origin and d = ray.direction in
  let dx = d.x and dy = d.y and dz = d.z in
  let x = o.x -. f.cx and y = o.y -. f.cy and z = o.z -. f.cz in
  let ux = dot f.axx f.axy f.axz dx dy dz
  and uy = dot f.axy f.ayy f.ayz dx dy dz
  and uz = dot f.axz f.ayz f.azz dx dy dz in
  let a = dot ux uy uz dx dy dz in
  let b = dot ux uy uz x y z +. dot f.gx f.gy f.gz dx dy dz in
  let dx = abs dx and dy = abs dy and dz = abs dz in
  let ux = dot (abs f.axx) (abs f.axy) (abs f.axz) dx dy dz
  and uy = dot (abs f.axy) (abs f.ayy) (abs f.ayz) dx dy dz
  and uz = dot (abs f.axz) (abs f.ayz) (abs f.azz) dx dy dz in
  let a' = 10. *. dot ux uy uz dx dy dz
  and b' =
    16.
    *. (dot ux uy uz (abs x) (abs y) (abs z)
       +. dot (abs f.gx) (abs f.gy) (abs f.gz) dx dy dz)
  in
  let ahead = match (side : Side.t) with Outside -> -1. | Inside -> 1. in
  let sure = a' > 0x1p-900 && b' > 0x1p-900 && a' < 0x1p900 && b' < 0x1p900 in
  (* Then low parts count for no more than roundings. *)
  let near = 0x1p52 *. Vec.norm1 ray.origin_low <= abs x +. abs y +. abs z in
  if q.linear || (sure && ahead *. a < -0x1p-52 *. a') then Contact.none
  else if sure && near && a' <= 0x1p5 *. abs a && b' <= 0x1p5 *. abs b then
    if ahead *. b < 0. then consider q ray (-2. *. (b /. a)) b Second cursor
    else Contact.none
  else Careful_form.meet_again q ray side cursor

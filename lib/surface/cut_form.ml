open Candor_number
open Candor_space

type t = {
  form : Form.t;
  linear : bool;
  cuts : Half_space.t array;
  disks : int array;
}

let make form ~cuts ~disks = { form; linear = Form.is_linear form; cuts; disks }

(* {1 Cutting} *)

let exact_equation q o d =
  let f = Unrounded.diff o (Form.center q.form) in
  Form.along_exactly q.form f (Unrounded.vec d)

(* What t is a root of: F along the ray, or the plane of one of the cuts. *)
type solved = Of_form of { falling : bool } | Of_cut of int

let within_cuts q o d t solved ~except =
  let inside i h =
    i = except
    ||
    match Half_space.verdict h o d t with
    | Half_space.In -> true
    | Out -> false
    | Unsure -> (
        let cut = Half_space.along h o d in
        match solved with
        | Of_form { falling } ->
            Root.is_within (exact_equation q o d) ~falling cut
        | Of_cut k ->
            let v, w = Half_space.along q.cuts.(k) o d in
            let v', w' = cut in
            let open Expansion in
            (* v' + t w' <= 0 where t = -v/w *)
            sign w * sign (sub (mul v' w) (mul v w')) <= 0)
  in
  let rec all i =
    i = Array.length q.cuts || (inside i q.cuts.(i) && all (i + 1))
  in
  all 0

(* {1 Meeting} *)

let contact_of_root b root =
  Contact.v ~part:0 (if Root.falls ~b root then Side.Outside else Inside)

let consider q o d t b root cursor =
  if
    t > 0. && t <= cursor.Cursor.t
    && within_cuts q o d t
         (Of_form { falling = Root.falls ~b root })
         ~except:(-1)
  then Cursor.take cursor t (contact_of_root b root)
  else Contact.none

let[@inline] later earlier last = if Contact.is_none last then earlier else last

let consider_both q o d ~first ~second b cursor =
  let earlier = consider q o d first b Root.First cursor in
  later earlier (consider q o d second b Root.Second cursor)

(* dAd, exactly, rounded to a double-double: along a generator it cancels to
   less than double-double leaves of it. *)
let exact_bend f (d : Double_double.vec) =
  let zero = Expansion.of_float 0. in
  let d = Unrounded.vec (Vec.v d.x.hi d.y.hi d.z.hi) in
  let a, _, _ = Form.along_exactly f { x = zero; y = zero; z = zero } d in
  let hi = Expansion.to_float a in
  let rest = Expansion.(sub a (of_float hi)) in
  { Error_free.hi; lo = Expansion.to_float rest }

let bend f unit (a : Double_double.t) =
  if a.hi = 0. || Float.abs a.hi > 0x1p-45 *. f.Form.a_size then a
  else exact_bend f unit

(* The second tier: everything in double-double, the discriminant at the point
   of the line nearest to the centre. *)
let meet_carefully q (o : Point.t) (d : Vec.t) cursor =
  let open Double_double in
  let unit, e = Unrounded.pair_near_one d in
  let back t = Float.ldexp (to_float t) (-e) in
  let f = Unrounded.pair_diff o (Form.center q.form) in
  let { Form.a; b; c } = Form.along q.form f unit in
  let a = bend q.form unit a in
  if a.hi = 0. then
    if b.hi = 0. then Contact.none
    else
      let t = back (div (neg c) (add b b)) in
      consider q o d t b.hi First cursor
  else
    let closest = -.((dot f unit).hi /. (dot unit unit).hi) in
    let at = Form.along q.form (Double_double.along f closest unit) unit in
    let disc = sub (mul at.b at.b) (mul a at.c) in
    if not (disc.hi >= 0.) then Contact.none
    else
      let root = sqrt disc in
      let r = if b.hi >= 0. then neg (add b root) else sub root b in
      let first = if r.hi = 0. then 0. else back (div c r) in
      consider_both q o d ~first ~second:(back (div r a)) b.hi cursor

let meet_linear q (o : Point.t) (d : Vec.t) cursor =
  let f = q.form in
  let abs = Float.abs in
  let fx = o.x -. f.cx and fy = o.y -. f.cy and fz = o.z -. f.cz in
  let bx = f.gx *. d.x and by = f.gy *. d.y and bz = f.gz *. d.z in
  let cx = f.gx *. fx and cy = f.gy *. fy and cz = f.gz *. fz in
  let b = bx +. by +. bz in
  let c = (2. *. (cx +. cy +. cz)) +. f.k in
  let b_size = abs bx +. abs by +. abs bz in
  let c_size = (2. *. (abs cx +. abs cy +. abs cz)) +. abs f.k in
  if b_size <= 2. *. abs b && c_size <= 2. *. abs c && b_size > 0x1p-900 then
    let t = -.c /. (2. *. b) in
    if t > 0. && t <= cursor.Cursor.t then consider q o d t b Root.First cursor
    else Contact.none
  else meet_carefully q o d cursor

(* The first tier: plain doubles, with bounds on their errors in units of u from
   the same products of absolute values (names with a prime). Roots come from the
   ray's origin, the discriminant from p, the point of the line where F has its
   extremum: there it hardly cancels. A number x is accepted when it is known
   within 2^5 u of x (the discriminant, of which the root is taken, 2^6 u), a miss
   when the discriminant is below its error. *)
let meet_curved q (o : Point.t) (d : Vec.t) cursor =
  let open Error_free in
  let f = q.form and abs = Float.abs in
  let dx = d.x and dy = d.y and dz = d.z in
  let fx = o.x -. f.cx and fy = o.y -. f.cy and fz = o.z -. f.cz in
  (* A d and A f + g *)
  let ux = dot f.axx f.axy f.axz dx dy dz
  and uy = dot f.axy f.ayy f.ayz dx dy dz
  and uz = dot f.axz f.ayz f.azz dx dy dz in
  let wx = dot f.axx f.axy f.axz fx fy fz +. f.gx
  and wy = dot f.axy f.ayy f.ayz fx fy fz +. f.gy
  and wz = dot f.axz f.ayz f.azz fx fy fz +. f.gz in
  let a = dot ux uy uz dx dy dz in
  let b = dot wx wy wz dx dy dz in
  let c = dot wx wy wz fx fy fz +. dot f.gx f.gy f.gz fx fy fz +. f.k in
  let t = -.b /. a in
  let px = Float.fma t dx fx
  and py = Float.fma t dy fy
  and pz = Float.fma t dz fz in
  let vx = dot f.axx f.axy f.axz px py pz +. f.gx
  and vy = dot f.axy f.ayy f.ayz px py pz +. f.gy
  and vz = dot f.axz f.ayz f.azz px py pz +. f.gz in
  let bp = dot vx vy vz dx dy dz in
  let cp = dot vx vy vz px py pz +. dot f.gx f.gy f.gz px py pz +. f.k in
  let disc = difference_of_products bp bp a cp in
  (* What rounding f has lost, in units of u. *)
  let lx = 0x1p53 *. abs (sum_error o.x (-.f.cx) fx)
  and ly = 0x1p53 *. abs (sum_error o.y (-.f.cy) fy)
  and lz = 0x1p53 *. abs (sum_error o.z (-.f.cz) fz) in
  let dx = abs dx and dy = abs dy and dz = abs dz in
  let fx = abs fx and fy = abs fy and fz = abs fz in
  (* As large as p can be, f being rounded. *)
  let px = abs px +. (0x1p-53 *. lx)
  and py = abs py +. (0x1p-53 *. ly)
  and pz = abs pz +. (0x1p-53 *. lz) in
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
  let a' = 8. *. dot ux uy uz dx dy dz in
  let bp' = (10. *. (dot ux uy uz px py pz +. gd)) +. dot ux uy uz lx ly lz in
  let cp' =
    (12. *. (dot vx vy vz px py pz +. k)) +. (2. *. dot vx vy vz lx ly lz)
  in
  let disc' =
    (2. *. abs bp *. bp')
    +. (abs a *. cp')
    +. (abs cp *. a')
    +. (4. *. abs disc)
    +. (0x1p-52 *. ((bp' *. bp') +. (a' *. cp')))
  in
  if not (disc' > 0x1p-800 && disc' < 0x1p900 && a' <= 0x1p5 *. abs a) then
    meet_carefully q o d cursor
  else if disc < -0x1p-52 *. disc' then Contact.none
  else
    let wx = dot axx axy axz fx fy fz +. (2. *. gx)
    and wy = dot axy ayy ayz fx fy fz +. (2. *. gy)
    and wz = dot axz ayz azz fx fy fz +. (2. *. gz) in
    let b' = 12. *. (dot ux uy uz fx fy fz +. gd) in
    let c' =
      (12. *. (dot wx wy wz fx fy fz +. k)) +. (2. *. dot wx wy wz lx ly lz)
    in
    let root = sqrt disc in
    let r = if b >= 0. then -.(b +. root) else root -. b in
    if
      disc' <= 0x1p6 *. disc
      && c' <= 0x1p5 *. abs c
      && b' <= 0x1p5 *. abs r
      && abs b > 0x1p-50 *. b'
    then consider_both q o d ~first:(c /. r) ~second:(r /. a) b cursor
    else meet_carefully q o d cursor

let meet_surface q o d cursor =
  if q.linear then meet_linear q o d cursor else meet_curved q o d cursor

(* With the origin on the surface the equation is t (a t + 2 b) = 0. Leaving
   outwards F rises, so b > 0, and the other root is ahead only if a < 0. *)
let meet_again_carefully q o d side cursor =
  let unit, e = Unrounded.pair_near_one d in
  let { Form.a; b; c = _ } =
    Form.along q.form (Unrounded.pair_diff o (Form.center q.form)) unit
  in
  let ahead =
    match (side : Side.t) with
    | Outside -> b.hi > 0. && a.hi < 0.
    | Inside -> b.hi < 0. && a.hi > 0.
  in
  if not ahead then Contact.none
  else
    let t = -2. *. Float.ldexp (b.hi /. a.hi) (-e) in
    consider q o d t b.hi Second cursor

(* Most often the sign of a alone tells that nothing is ahead. *)
let meet_again q o (d : Vec.t) side cursor =
  if q.linear then Contact.none
  else
    let f = q.form in
    let d2 = Vec.dot d d in
    let a = Vec.dot d (Form.gradient f d) -. Vec.dot d (Form.slope f) in
    let doubt = 0x1p-49 *. ((f.a_size *. d2) +. (f.g_size *. sqrt d2)) in
    let a = match (side : Side.t) with Outside -> a | Inside -> -.a in
    if a > doubt then Contact.none else meet_again_carefully q o d side cursor

(* Whether F <= 0 where the ray crosses the plane of a cut: by its double at the
   rounded point unless that could be rounding, else exactly. *)
let on_disk q o d t cut =
  let p = Point.along o d t in
  let f = q.form in
  let y = Point.sub p (Form.center f) in
  let g = Form.gradient f y in
  let value = Vec.dot g y +. Vec.dot (Form.slope f) y +. f.k in
  let norm1 (v : Vec.t) = Float.abs v.x +. Float.abs v.y +. Float.abs v.z in
  let reach = norm1 (Point.sub o (Form.center f)) +. (t *. norm1 d) in
  (* y is off by 8 ulp of t d and the roundings of p and y. *)
  let slope = (f.a_size *. reach) +. f.g_size in
  let doubt = 0x1p-46 *. ((slope *. reach) +. Float.abs f.k) in
  if value < -.doubt then true
  else if value > doubt then false
  else
    let a, b, c = exact_equation q o d in
    let v, w = Half_space.along cut o d in
    let open Expansion in
    let ab = sub (mul a v) (mul b w) and bc = sub (mul b v) (mul c w) in
    (* w^2 F(-v/w) = v (a v - b w) - w (b v - c w) *)
    sign (sub (mul v ab) (mul w bc)) <= 0

(* Where the ray crosses the plane of a cut, and how fast. *)
let cut_distance h o d =
  let unit, e = Unrounded.pair_near_one d in
  let across = Double_double.dot (Half_space.normal h) unit in
  let t = Double_double.(to_float (div (Half_space.depth h o) across)) in
  (Float.ldexp t (-e), across.hi)

let meet_disk q (o : Point.t) (d : Vec.t) end_ left cursor =
  let h = q.cuts.(end_) in
  let part = end_ + 1 in
  if (not (Contact.is_none left)) && Contact.part left = part then Contact.none
  else
    let t, across = cut_distance h o d in
    if
      t > 0. && t <= cursor.Cursor.t && on_disk q o d t h
      && within_cuts q o d t (Of_cut end_) ~except:end_
    then
      Cursor.take cursor t
        (Contact.v ~part (if across < 0. then Outside else Inside))
    else Contact.none

let meet q o d left cursor =
  let found =
    if Contact.is_none left || Contact.part left <> 0 then
      meet_surface q o d cursor
    else meet_again q o d (Contact.side left) cursor
  in
  let add found end_ = later found (meet_disk q o d end_ left cursor) in
  if Array.length q.disks = 0 then found else Array.fold_left add found q.disks

(** Spheres in exact arithmetic. *)

open Candor_space

let center (s : Candor_surface.Sphere.t) = Dyadic_vec.of_floats s.x s.y s.z

(* How far t may be off besides its ulps: 2^-96 of the distances, and what a
   blurred line adds, which moves a constant of the equation by [blur]. *)
let slack (line : Line.t) ~reach ~radius (p : Exact_root.quadratic) =
  let open Wide in
  let near = of_dyadic Dyadic.(shift (-96) (radius + reach)) in
  let plain = div near (of_dyadic (Dyadic_vec.largest line.direction)) in
  if Line.is_sharp line then plain
  else
    let a = of_dyadic p.a and d = abs (of_dyadic p.discriminant) in
    let t = div (of_dyadic Dyadic.(radius + reach)) (sqrt a) in
    let off =
      add
        (of_dyadic line.blur.of_origin)
        (mul t (of_dyadic line.blur.of_direction))
    in
    let blur = mul (of_float 4.) (mul (of_dyadic radius) off) in
    let steep = div blur (sqrt d) and grazing = sqrt (div blur a) in
    add plain (if d.x = 0. then grazing else min steep grazing)

(* Whether the decision is nearer to tangency than 2^-96, or than the blur. *)
let band (line : Line.t) ~reach ~radius (p : Exact_root.quadratic) =
  let open Dyadic in
  let d = Dyadic_vec.size line.direction in
  let scale = (radius * radius) + (reach * reach) in
  let blur = (reach * line.blur.of_direction) + (d * line.blur.of_origin) in
  leq (abs p.discriminant)
    (shift (-96) (p.a * scale) + shift 2 (radius * d * blur))

let truth_along (s : Candor_surface.Sphere.t) (line : Line.t) =
  let f = Line.from line (center s) and d = line.direction in
  let radius = Dyadic.(of_float s.radius * line.weight) in
  let p =
    Dyadic_vec.(
      Exact_root.quadratic
        (dot d d, dot f d, Dyadic.(dot f f - (radius * radius))))
  in
  let at side root = { Crossing.at = root; side; part = 0 } in
  let crossings =
    match Exact_root.roots p with
    | [ near; far ] -> [ at Side.Outside near; at Side.Inside far ]
    | _ -> []
  in
  let reach = Dyadic_vec.size f in
  {
    Crossing.crossings;
    band = lazy (band line ~reach ~radius p);
    slack = Crossing.slack (slack line ~reach ~radius p);
  }

(** [truth s line] is where [line] crosses [s]. *)
let truth s line = truth_along s (Crossing.exact line)

open Exact

(** [equation s line] is (a, h, c) with a t² + 2 h t + c = 0 on the sphere. *)
let equation (s : Candor_surface.Sphere.t)
    { Crossing.origin = o; direction = d } =
  let f = sub o (v (q s.x) (q s.y) (q s.z)) and r = q s.radius in
  (dot d d, dot f d, dot f f - (r * r))

(** [value s p] is |p − centre|² − radius². *)
let value (s : Candor_surface.Sphere.t) p =
  let f = sub p (v (q s.x) (q s.y) (q s.z)) and r = q s.radius in
  dot f f - (r * r)

open Candor_space
open Candor_sample
open Candor_oracle
open QCheck2
module T = Spherical_triangle

type corners = { a : Vec.t; b : Vec.t; c : Vec.t }

let seen { a; b; c } = T.make a b c
let solid_angle t = T.solid_angle (seen t)
let map f { a; b; c } = { a = f a; b = f b; c = f c }
let v = Vec.v
let unit a = (Option.get (Dir.of_vec a) :> Vec.t)
let octant = { a = v 1. 0. 0.; b = v 0. 5. 0.; c = v 0. 0. 0.1 }
let show { a; b; c } = String.concat " " (List.map Draw.show_vec [ a; b; c ])

let near name within expected value =
  Agreement.close name ~within expected value

(* {1 Triangles} *)

(* Two edges of about [size] from a corner that is 1 away, and not in its line. *)
let of_size size =
  let open Gen in
  let* a = Draw.unit in
  let* across = Draw.across a
  and* lengths = pair (Draw.uniform 0.3 1.) (Draw.uniform 0.3 1.) in
  let* other = Draw.uniform (-0.8) 0.8 and* tilt = Draw.uniform (-0.5) 0.5 in
  let aside = Vec.cross a across in
  let edge k d = Vec.scale (size *. k) (Vec.add d (Vec.scale tilt a)) in
  let e = edge (fst lengths) across in
  let f = edge (snd lengths) (Vec.add (Vec.scale other across) aside) in
  return { a; b = Vec.add a e; c = Vec.add a f }

let fair =
  let open Gen in
  let* size = oneof [ Draw.uniform 0.01 1.5; Draw.power (-44) 0 ] in
  of_size size

(* Corners anywhere, at any distance. *)
let wild =
  let open Gen in
  let corner =
    let+ d = Draw.unit and+ k = Draw.wide (-4.) 4. in
    Vec.scale k d
  in
  let+ a = corner and+ b = corner and+ c = corner in
  { a; b; c }

let any = Gen.oneof [ fair; wild ]

let tiny =
  {
    a = v 0x1p28 0x1p27 (-0x1p26);
    b = v (0x1p28 +. 7.) (0x1p27 -. 3.) (-0x1p26 +. 1.);
    c = v (0x1p28 -. 2.) (0x1p27 +. 5.) (-0x1p26 +. 6.);
  }

let examples =
  [
    ("an octant", octant);
    ("a small one", { a = v 1. 0. 0.; b = v 1. 0.01 0.; c = v 1. 0. 0.02 });
    ("a tiny one from afar", tiny);
    ( "a wide one",
      { a = v 1. 0. 0.05; b = v (-0.5) 0.9 0.05; c = v (-0.5) (-0.9) 0.05 } );
    ( "an oblique one",
      { a = v 1. 0. 0.1; b = v 9. 0.3 0.1; c = v 9. (-0.3) 0.1 } );
    ("a needle", { a = v 1. 0. 0.; b = v 1. 3. 0x1p-20; c = v 1. 3. 0. });
    ( "one 2^-35 across",
      { a = v 1. 0. 0.; b = v 1. 0x1p-35 0.; c = v 1. 0. 0x1p-35 } );
  ]

(* {1 Solid angles} *)

let known () =
  near "octant" 0x1p-51 (Float.pi /. 2.) (solid_angle octant);
  (* A face of a regular tetrahedron, of a cube cut along a diagonal, and what
     is left of half the sky 2^-30 above a triangle. *)
  let tetrahedron =
    { a = v 1. 1. 1.; b = v 1. (-1.) (-1.); c = v (-1.) 1. (-1.) }
  in
  near "tetrahedron" 0x1p-50 Float.pi (solid_angle tetrahedron);
  let half_face = { a = v 1. 1. 1.; b = v 1. (-1.) 1.; c = v 1. (-1.) (-1.) } in
  near "half of a cube's face" 0x1p-50 (Float.pi /. 3.) (solid_angle half_face);
  let above =
    {
      a = v 1. 0. 0x1p-30;
      b = v (-0.5) 0.75 0x1p-30;
      c = v (-0.5) (-0.75) 0x1p-30;
    }
  in
  near "just above it" 0x1p-27 (2. *. Float.pi) (solid_angle above);
  (* Of an area A that is square on to the view at 1: A less what is of order
     A^2. *)
  let e = 0x1p-25 in
  let small = { a = v 0. 0. 1.; b = v e 0. 1.; c = v 0. e 1. } in
  near "2^-51" 0x1p-48 (e *. e /. 2.) (solid_angle small);
  let far = map (Vec.ldexp 400) small in
  near "the same from far" 0. (solid_angle small) (solid_angle far)

(* The determinant exactly, the rest in doubles where nothing cancels. *)
let exact_volume { a; b; c } =
  let q = Q.of_float in
  let minor x y z w = Q.sub (Q.mul (q x) (q y)) (Q.mul (q z) (q w)) in
  let open Vec in
  Q.to_float
    (Q.abs
       (Q.add
          (Q.mul (q a.x) (minor b.y c.z b.z c.y))
          (Q.add
             (Q.mul (q a.y) (minor b.z c.x b.x c.z))
             (Q.mul (q a.z) (minor b.x c.y b.y c.x)))))

let accurate t =
  let v = exact_volume t /. Vec.norm t.a /. Vec.norm t.b /. Vec.norm t.c in
  let { a; b; c } = map unit t in
  let past = 1. +. Vec.dot a b +. Vec.dot b c +. Vec.dot c a in
  let exact = 2. *. Float.atan2 v past in
  let got = solid_angle t in
  got >= 0.
  && got <= 2. *. Float.pi *. (1. +. 0x1p-52)
  && (past < 0.1 || Float.abs (got -. exact) <= 0x1p-40 *. exact)

(* Four parts, by the middles of the sides. *)
let parts t =
  let mid a b = Vec.scale 0.5 (Vec.add a b) in
  let ab = mid t.a t.b and bc = mid t.b t.c and ca = mid t.c t.a in
  [
    { t with b = ab; c = ca };
    { t with a = ab; c = bc };
    { t with a = ca; b = bc };
    { a = bc; b = ca; c = ab };
  ]

(* What rounding in the coordinates is in the sides of a triangle. *)
let blur t =
  let { a; b; c } = map unit t in
  let side x y = Vec.norm (Vec.sub x y) in
  0x1p-48 /. Float.min (side a b) (Float.min (side b c) (side c a))

let adds_up t =
  let sum = List.fold_left (fun s t -> s +. solid_angle t) 0. (parts t) in
  Float.abs (sum -. solid_angle t) <= blur t *. sum

(* The faces of a tetrahedron about the point fill the sky; where it is flat,
   rounding may leave the point outside. *)
let closed (t, (k, l, m)) =
  let u = map unit t in
  let sum = Vec.(add (scale k u.a) (add (scale l u.b) (scale m u.c))) in
  let d = Vec.scale (-.Vec.norm t.b) sum in
  Float.abs (Vec.dot u.a (Vec.cross u.b u.c)) < 0x1p-6
  ||
  let faces = [ t; { t with a = d }; { t with b = d }; { t with c = d } ] in
  let sum = List.fold_left (fun s t -> s +. solid_angle t) 0. faces in
  Float.abs (sum -. (4. *. Float.pi)) <= 0x1p-40

let flat () =
  List.iter
    (fun (name, a, b, c) ->
      let t = T.make a b c in
      Alcotest.(check (float 0.)) name 0. (T.solid_angle t);
      Alcotest.(check (float 0.)) name 0. (T.density t);
      let d = (T.sample t { u = 0.3; v = 0.6 } :> Vec.t) in
      near name 0x1p-50 1. (Vec.norm d))
    [
      ("a point", Vec.zero, Vec.zero, Vec.zero);
      ("at a corner", Vec.zero, v 1. 0. 0., v 0. 1. 0.);
      ("on a side", v (-1.) 0. 0., v 1. 0. 0., v 0. 1. 0.);
      ("inside", v 1. 0. 0., v (-1.) 2. 0., v (-1.) (-2.) 0.);
      ("beside", v 1. 0. 0., v 2. 2. 0., v 3. (-2.) 0.);
      ("edge on and rounded", v 0.1 0.3 0., v 0.7 0.9 0., v 1.3 0.2 0.);
      ("no area", v 1. 2. 3., v 1. 2. 3., v 0. 1. 0.);
      ("no area, far", v 1. 0. 0x1p60, v 1. 0. 0x1p60, v 1. 0. 0x1p60);
      ("not finite", v nan 0. 0., v 0. 1. 0., v 0. 0. 1.);
      ("infinite", v infinity 0. 0., v 0. 1. 0., v 0. 0. 1.);
    ]

(* {1 Samples} *)

let triple a b c = Vec.dot a (Vec.cross (Vec.sub b a) (Vec.sub c a))

(* The weights of the corners, as directions, in a direction. *)
let weights t (d : Dir.t) =
  let { a; b; c } = map unit t and d = (d :> Vec.t) in
  let p = triple d b c and q = triple a d c and r = triple a b d in
  let s = p +. q +. r in
  (p /. s, q /. s, r /. s)

let place =
  let one =
    Gen.oneof
      [
        Draw.uniform 0. (Float.pred 1.);
        Draw.pick [ 0.; Float.pred 1.; 0x1p-53; 0.5 ];
      ]
  in
  Gen.map2 (fun u v -> { Pattern.u; v }) one one

let show_case (t, { Pattern.u; v }) = Printf.sprintf "%h %h in %s" u v (show t)

let inside (t, p) =
  let slack = 2. *. blur t in
  let d = T.sample (seen t) p in
  let p, q, r = weights t d in
  Float.abs (Vec.norm (d :> Vec.t) -. 1.) <= 0x1p-50
  && p >= -.slack && q >= -.slack && r >= -.slack

let total (t, p) =
  Float.abs (Vec.norm (T.sample (seen t) p :> Vec.t) -. 1.) <= 0x1p-50

(* Rows of small triangles, alternately upright and not. *)
let n = 6

let small_triangle t i =
  let { a; b; c } = map unit t in
  let row = i / (2 * n)
  and column = i mod (2 * n) / 2
  and turned = i mod 2 = 1 in
  let at q r =
    let e = Vec.scale (float_of_int q /. float_of_int n) (Vec.sub b a)
    and f = Vec.scale (float_of_int r /. float_of_int n) (Vec.sub c a) in
    Vec.add a (Vec.add e f)
  in
  let q = row and r = column in
  if (q + r + if turned then 1 else 0) >= n then None
  else if turned then
    Some { a = at (q + 1) r; b = at q (r + 1); c = at (q + 1) (r + 1) }
  else Some { a = at q r; b = at (q + 1) r; c = at q (r + 1) }

let small_triangle_of t d =
  let p, q, r = weights t d in
  let part w =
    Int.max 0 (Int.min (n - 1) (int_of_float (w *. float_of_int n)))
  in
  let i = part q and j = part r in
  let turned = i + j + part p < n - 1 in
  (i * 2 * n) + (2 * j) + if turned then 1 else 0

let uniform () =
  List.iter
    (fun (name, t) ->
      let area i =
        match small_triangle t i with Some t -> solid_angle t | None -> 0.
      in
      let expected = Array.init (2 * n * n) area in
      let s = seen t in
      near name 1e-6 (T.solid_angle s) (Array.fold_left ( +. ) 0. expected);
      let bin i = small_triangle_of t (T.sample s (Agreement.position i)) in
      Chi_square.(against name expected (count (2 * n * n) 50_000 bin)))
    examples

(* The integral of directions over a triangle, J. H. Lambert, Photometria, 1760:
   half the sum of its sides' angles times their normals. *)
let moment t =
  let { a; b; c } = map unit t in
  let side a b =
    let n = Vec.cross a b in
    let s = Vec.norm n in
    if s = 0. then Vec.zero
    else Vec.scale (Float.atan2 s (Vec.dot a b) /. s /. 2.) n
  in
  let sum = Vec.add (side a b) (Vec.add (side b c) (side c a)) in
  if triple a b c < 0. then Vec.neg sum else sum

let mean t =
  let key = Key.v ~seed:3 ~x:1 ~y:0 ~sample:0 ~bounce:0 Film and s = seen t in
  let points = 4096 in
  let sum = ref Vec.zero in
  for i = 0 to points - 1 do
    sum := Vec.add !sum (T.sample s (Sobol.pair ~key i) :> Vec.t)
  done;
  Vec.scale (1. /. float_of_int points) !sum

let moments () =
  List.iter
    (fun (name, t) ->
      let exact = Vec.scale (T.density (seen t)) (moment t) in
      let off = Vec.norm (Vec.sub (mean t) exact) in
      if off > 2e-4 then Alcotest.failf "%s: its mean is %g off" name off)
    (List.filter (fun (_, t) -> solid_angle t > 1e-4) examples)

(* All over the sky: as many directions fall into the triangle as into the
   solid angle. *)
let brute_force () =
  let cases = 200_000 in
  let key = Key.v ~seed:4 ~x:1 ~y:0 ~sample:0 ~bounce:0 Film in
  List.iter
    (fun name ->
      let t = List.assoc name examples in
      let { a; b; c } = map unit t in
      let s = Float.copy_sign 1. (triple a b c) in
      let hits = ref 0 in
      for i = 0 to cases - 1 do
        let d = (Warp.sphere (Sobol.pair ~key i) :> Vec.t) in
        let within p q = s *. Vec.dot d (Vec.cross p q) >= 0. in
        if within a b && within b c && within c a then incr hits
      done;
      let found = 4. *. Float.pi *. float_of_int !hits /. float_of_int cases in
      Alcotest.(check (float 2e-3)) name (solid_angle t) found)
    [ "an octant"; "a wide one"; "an oblique one" ]

let scales ((t, p), k) =
  let t' = map (Vec.ldexp k) t in
  Float.equal (solid_angle t) (solid_angle t')
  && Dir.equal (T.sample (seen t) p) (T.sample (seen t') p)

let density (t, _) =
  let s = T.solid_angle (seen t) in
  let d = T.density (seen t) in
  if s = 0. then d = 0. else Float.abs ((d *. s) -. 1.) <= 0x1p-51

let law name gen print f = Law.law ~count:3000 ~print name gen f

let suite =
  let case = Gen.pair any place in
  ( "spherical triangles",
    [
      Law.example "solid angles of an octant, a tetrahedron, a cube, 2^-51"
        known;
      law "solid angles agree with the exact determinant" any show accurate;
      law "four parts of a triangle have its solid angle" fair show adds_up;
      law "the faces of a tetrahedron around the point have 4 pi"
        Gen.(
          pair wild
            (triple (Draw.uniform 0.1 1.) (Draw.uniform 0.1 1.)
               (Draw.uniform 0.1 1.)))
        (fun (t, _) -> show t)
        closed;
      Law.example "a triangle in one plane with the point has solid angle 0"
        flat;
      law "samples are inside, for sides down to 2^-44" (Gen.pair fair place)
        show_case inside;
      law "samples are directions" case show_case total;
      Law.example "samples are uniform by solid angle" uniform;
      Law.example "the mean direction is Lambert's" moments;
      Law.example "as much of the sky is inside as the solid angle says"
        brute_force;
      law "lengths times 2^k leave the bits"
        Gen.(pair case (int_range (-300) 300))
        (fun (c, k) -> Printf.sprintf "%s, 2^%d" (show_case c) k)
        scales;
      law "the density is 1 over the solid angle" case show_case density;
    ] )

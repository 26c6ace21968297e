open Candor_space
open Candor_optics
open Candor_oracle
open QCheck2

let dir x y z = Dir.of_vec_or Dir.z (Vec.v x y z)
let slant = dir 0.3 (-0.5) 0.8
let alphas = [ 0x1p-20; 0x1p-10; 0.05; 0.3; 1. ]

(* At cosine [c] to the normal [n]. *)
let at n c =
  let f = Frame.of_dir n and s = sqrt ((1. -. c) *. (1. +. c)) in
  let turn k (d : Dir.t) = Vec.scale k (d :> Vec.t) in
  Dir.of_vec_or n
    (Vec.add (turn c f.w) (Vec.add (turn (0.6 *. s) f.u) (turn (0.8 *. s) f.v)))

let cosines = [ 1.; 0.7; 0.2; 0x1p-6; 0x1p-20 ]

let alpha =
  Gen.oneof
    [
      Draw.uniform 0.01 1.;
      Draw.wide (-6.) 0.;
      Draw.pick [ 0x1p-32; 0x1p-20; 1. ];
    ]

let cosine =
  Gen.oneof
    [ Draw.uniform 0. 1.; Draw.wide (-20.) 0.; Draw.nudged (Draw.pick [ 1. ]) ]

let number =
  Gen.oneof
    [
      Draw.uniform 0. 0x1.fffffffffffffp-1;
      Draw.pick [ 0.; 0x1p-53; 0x1.fffffffffffffp-1 ];
    ]

(* {1 The distribution} *)

let normalised () =
  List.iter
    (fun alpha ->
      let sphere = Directions.around slant ~width:alpha in
      let area (h : Dir.t) =
        Dir.dot slant h
        *. Microfacet.distribution ~alpha ~normal:slant (h :> Vec.t)
      in
      Near.float ~within:0x1p-9
        (Printf.sprintf "alpha %g" alpha)
        1.
        (Directions.integral sphere area))
    alphas

(* Of vectors as they are, not quite of length 1. *)
let exact_distribution alpha n h =
  let open Exact in
  let n = vec n and h = vec h and a2 = q alpha * q alpha in
  let along = dot n h and across = cross n h in
  let spread = dot n n * dot h h / ((a2 * along * along) + dot across across) in
  a2 * spread * spread

let peak =
  let open Gen in
  let* alpha = alpha and* n = Draw.unit and* far = Draw.wide (-3.) 3. in
  let* aside = Draw.across n and* length = Draw.power (-300) 300 in
  let alpha = Float.max alpha 0x1p-20 in
  return
    (alpha, n, Vec.scale length (Vec.add n (Vec.scale (alpha *. far) aside)))

let show_peak (alpha, n, h) =
  Printf.sprintf "alpha %h, normal %s, %s" alpha (Draw.show_vec n)
    (Draw.show_vec h)

let sharp (alpha, n, h) =
  let normal = Dir.of_vec_or Dir.z n in
  let d = Microfacet.distribution ~alpha ~normal h *. Float.pi in
  let truth = exact_distribution alpha (normal :> Vec.t) h in
  let off = Q.to_float Exact.((q d - truth) / truth) in
  Float.abs off <= 0x1p-49 /. alpha

(* {1 Smith's functions} *)

let smith (alpha, c, c') =
  let l = Microfacet.lambda ~alpha c and l' = Microfacet.lambda ~alpha c' in
  let near = Near.close ~within:0x1p-45 in
  near (Microfacet.masking ~alpha c) (1. /. (1. +. l))
  && near (Microfacet.shared_masking ~alpha c c') (1. /. (1. +. l +. l'))
  && near (Microfacet.seen_again ~alpha c c') ((1. +. l) /. (1. +. l +. l'))

let known () =
  let l = Microfacet.lambda in
  Near.float "slope 1 / alpha" ((sqrt 2. -. 1.) /. 2.) (l ~alpha:1. (sqrt 0.5));
  Near.float "straight on" 0. (l ~alpha:0.5 1.);
  Alcotest.(check (float 0.)) "along the surface" infinity (l ~alpha:0.5 0.);
  Alcotest.(check (float 0.))
    "from below" 0.
    (Microfacet.masking ~alpha:0.5 (-0.1));
  Alcotest.(check (float 0.))
    "all of it is hidden along the surface" 0.
    (Microfacet.masking ~alpha:0.5 0.)

(* The mirrors seen add up to the surface seen: Smith's defining integral. *)
let each f = List.iter (fun alpha -> List.iter (f alpha) cosines) alphas
let name alpha c = Printf.sprintf "alpha %g, cosine %g" alpha c

let seen_area () =
  each (fun alpha c ->
      let view = at slant c and sphere = Directions.around slant ~width:alpha in
      let visible half = Microfacet.visible ~alpha ~normal:slant ~view ~half in
      Near.float ~within:0x1p-8 (name alpha c) 1.
        (Directions.integral sphere visible))

(* {1 Sampling} *)

let sampled () =
  each (fun alpha c ->
      let view = at Dir.z c in
      let sphere = Directions.around Dir.z ~width:alpha in
      let density half = Microfacet.visible ~alpha ~normal:Dir.z ~view ~half in
      Directions.follows (name alpha c) sphere ~density (fun i ->
          let u = Directions.uniform i 0 and v = Directions.uniform i 1 in
          Dir.of_vec (Microfacet.seen ~alpha (view :> Vec.t) ~u ~v)))

let case =
  let open Gen in
  let* alpha = alpha and* c = cosine and* turn = Draw.uniform 0. 7. in
  let* u = number and* v = number in
  let c = Float.min 1. c in
  let s = sqrt ((1. -. c) *. (1. +. c)) in
  return (alpha, Vec.v (s *. cos turn) (s *. sin turn) c, u, v)

let show_case (alpha, view, u, v) =
  Printf.sprintf "alpha %h, view %s, numbers %h %h" alpha (Draw.show_vec view) u
    v

let proper (alpha, view, u, v) =
  let h = Microfacet.seen ~alpha view ~u ~v in
  Near.close (Vec.dot h h) 1. && h.z > 0. && Vec.dot view h > -0x1p-50

(* {1 Reflection} *)

let above n =
  let open Gen in
  let* c = cosine and* aside = Draw.across n in
  let c = Float.min 1. c in
  let s = sqrt ((1. -. c) *. (1. +. c)) in
  return (Dir.of_vec_or Dir.z (Vec.add (Vec.scale c n) (Vec.scale s aside)))

let meeting =
  let open Gen in
  let* alpha = alpha and* n = Draw.unit in
  let* view = above n and* toward = above n and* back = int_bound 9 in
  let opposite =
    Vec.sub (Vec.scale (2. *. Vec.dot n (view :> Vec.t)) n) (view :> Vec.t)
  in
  let toward = if back = 0 then Dir.of_vec_or Dir.z opposite else toward in
  return (alpha, Dir.of_vec_or Dir.z n, view, toward)

let show_meeting (alpha, (n : Dir.t), (v : Dir.t), (l : Dir.t)) =
  Printf.sprintf "alpha %h, normal %s, view %s, toward %s" alpha
    (Draw.show_vec (n :> Vec.t))
    (Draw.show_vec (v :> Vec.t))
    (Draw.show_vec (l :> Vec.t))

let reciprocal (alpha, normal, view, toward) =
  let f = Microfacet.reflection ~alpha ~normal in
  let there = f ~view ~toward and back = f ~view:toward ~toward:view in
  Float.is_finite there && there >= 0.
  && Float.abs (there -. back) <= 0x1p-48 *. there

let reflects (alpha, normal, view, (toward : Dir.t)) =
  let h = Vec.add (view : Dir.t :> Vec.t) (toward :> Vec.t) in
  let density = Microfacet.density ~alpha ~normal ~view ~toward in
  let c = Dir.dot normal view and c' = Dir.dot normal toward in
  match Dir.of_vec h with
  | Some half when c > 0. && c' > 0. && Vec.norm h > 0x1p-20 ->
      let visible = Microfacet.visible ~alpha ~normal ~view ~half in
      let blur = 0x1p-40 *. (1. +. (0x1p-10 /. alpha /. Vec.norm h)) in
      let value = Microfacet.reflection ~alpha ~normal ~view ~toward in
      let again = Microfacet.seen_again ~alpha c c' in
      Float.abs (density -. (visible /. (4. *. Dir.dot view half)))
      <= blur *. density
      && Float.abs ((value *. c') -. (again *. density)) <= 0x1p-45 *. density
  | _ -> true

let opposed () =
  let tiny = 0x1p-600 in
  let view = dir 1. 0. tiny and toward = dir (-1.) 0. tiny in
  let d = Microfacet.density ~alpha:0.5 ~normal:Dir.z ~view ~toward in
  Near.float "the peak, between grazing directions" (4. /. Float.pi) d;
  Alcotest.(check (float 0.))
    "nothing along no direction" 0.
    (Microfacet.distribution ~alpha:0.5 ~normal:Dir.z Vec.zero)

let meeting_law name = Law.law ~print:show_meeting name meeting

let suite =
  ( "microfacet",
    [
      Law.example "the mirrors' area, seen from above, is the surface's"
        normalised;
      Law.law ~print:show_peak
        "the peak is exact up to the rounding of the directions" peak sharp;
      Law.law
        ~print:(fun (a, c, c') -> Printf.sprintf "alpha %h at %h and %h" a c c')
        "masking is Smith's"
        (Gen.triple alpha cosine cosine)
        smith;
      Law.example "masking is as known at some angles" known;
      Law.example "the mirrors seen fill what is seen of the surface" seen_area;
      Law.example "mirrors are sampled as they are seen" sampled;
      Law.law ~print:show_case "a mirror sampled faces the viewer and outwards"
        case proper;
      meeting_law "mirrors reflect as much there as back" reciprocal;
      meeting_law "reflection is of the mirrors seen, less what others take"
        reflects;
      Law.example "grazing directions against each other are no trouble" opposed;
    ] )

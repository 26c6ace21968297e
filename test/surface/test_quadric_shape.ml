open Candor_space
open Candor_surface
open Candor_oracle
open Candor_surface_families
open QCheck2

let p = Point.v
let v = Vec.v
let o = Point.origin
let one = v 1. 1. 1.

(* {1 Checking} *)

let name : Quadric_shape.t -> string = function
  | Matrix _ -> "a matrix"
  | Form _ -> "a form"
  | Plane _ -> "a plane"
  | Ellipsoid _ -> "an ellipsoid"
  | Cylinder _ -> "a cylinder"
  | Cone _ -> "a cone"
  | Paraboloid _ -> "a paraboloid"
  | Hyperbolic_paraboloid _ -> "a hyperbolic paraboloid"
  | Hyperboloid_one_sheet _ -> "a hyperboloid of one sheet"
  | Hyperboloid_two_sheets _ -> "a hyperboloid of two sheets"

let axial : (Point.t -> Point.t -> float -> Quadric_shape.t) list =
  [
    (fun from until radius -> Cylinder { from; until; radius });
    (fun apex base radius -> Cone { apex; base; radius });
    (fun apex base radius -> Paraboloid { apex; base; radius });
  ]

let centred : (Point.t -> Vec.t -> Quadric_shape.t) list =
  [
    (fun center radii -> Ellipsoid { center; radii });
    (fun center radii -> Hyperbolic_paraboloid { center; radii });
    (fun center radii -> Hyperboloid_one_sheet { center; radii });
    (fun center radii -> Hyperboloid_two_sheets { center; radii });
  ]

let verdict expected s =
  match (Quadric_shape.check s, expected) with
  | Ok (), Ok () -> ()
  | Error why, Error wanted when why = wanted -> ()
  | found, _ ->
      Alcotest.(check (result unit string))
        (Quadrics.show_shape s) expected found

let accepts = verdict (Ok ())
let refuses why = verdict (Error why)
let far = Reach.message
let beyond = Float.succ 0x1p400

let ends_are_checked () =
  let up = p 0. 1. 0. in
  List.iter
    (fun make ->
      List.iter accepts
        [
          make o up 1.;
          make o up 0x1p400;
          make o up 0x1p-400;
          make o (p 0x1p-400 0. 0.) 1.;
          make (p (-0x1p399) 0. 0.) (p 0x1p399 0. 0.) 1.;
        ];
      List.iter (refuses far)
        [
          make (p beyond 0. 0.) up 1.;
          make o (p 0. nan 0.) 1.;
          make o up beyond;
          make o up nan;
          make o up infinity;
        ];
      List.iter
        (refuses "the radius must be above 0")
        [ make o up 0.; make o up (-0.); make o up (-1.) ];
      List.iter
        (refuses "the two ends must be apart, and the radius not below 2^-400")
        [
          make o o 1.;
          make up up 1.;
          make o (p 0x1p-401 0. 0.) 1.;
          make o up (Float.pred 0x1p-400);
        ])
    axial

let radii_are_checked () =
  List.iter
    (fun make ->
      List.iter accepts
        [
          make o one;
          make (p 0x1p400 0. (-0x1p400)) one;
          make o (v 0x1p-400 1. 0x1p400);
        ];
      List.iter (refuses far)
        [
          make (p 0. beyond 0.) one;
          make o (v 1. 1. beyond);
          make o (v nan 1. 1.);
          make o (v 1. infinity 1.);
        ];
      List.iter
        (refuses "the radii must be above 0")
        [ make o (v 0. 1. 1.); make o (v 1. (-1.) 1.); make o (v 1. 1. (-0.)) ];
      List.iter
        (refuses "the radii must not be below 2^-400")
        [
          make o (v (Float.pred 0x1p-400) 1. 1.);
          make o (v 1. 5e-324 1.);
          make o (v 1. 1. 0x1p-401);
        ])
    centred

let planes_are_checked () =
  let plane normal offset = Quadric_shape.Plane { normal; offset } in
  List.iter accepts [ plane one 0.; plane (v 0. 0x1p-400 0.) 0x1p400 ];
  refuses "the normal must not be zero" (plane (v 0. (-0.) 0.) 1.);
  List.iter (refuses far)
    [ plane (v 0. nan 1.) 0.; plane one beyond; plane (v beyond 0. 0.) 0. ]

(* Every pair across the diagonal is compared. *)
let symmetry_is_checked () =
  let ones n = Array.make (n * n) 1. in
  let off n k =
    let a = ones n in
    a.(k) <- 2.;
    a
  in
  let matrix q = Quadric_shape.Matrix q
  and form a = Quadric_shape.Form { a; b = one; c = 1. } in
  let each n make why =
    accepts (make (ones n));
    for k = 0 to (n * n) - 1 do
      if k / n = k mod n then accepts (make (off n k))
      else refuses why (make (off n k))
    done
  in
  each 4 matrix "the matrix is not symmetric: qij and qji must be equal";
  each 3 form "the form's a is not symmetric: aij and aji must be equal"

let numbers_are_checked () =
  List.iter
    (fun n ->
      if n <> 16 then
        refuses "a matrix has 16 numbers" (Matrix (Array.make n 1.));
      if n <> 9 then
        refuses "the form's a has 9 numbers"
          (Form { a = Array.make n 1.; b = one; c = 1. }))
    [ 0; 9; 12; 15; 16; 17 ];
  List.iter
    (fun x ->
      refuses far (Matrix (Array.make 16 x));
      refuses far (Form { a = Array.make 9 x; b = one; c = 0. });
      refuses far (Form { a = Array.make 9 1.; b = v 0. x 0.; c = 0. });
      refuses far (Form { a = Array.make 9 1.; b = one; c = x }))
    [ nan; infinity; neg_infinity; 1e300 ];
  let tiny = 0x1p-401 in
  let small = "the largest coefficient must not be below 2^-400" in
  refuses small (Matrix (Array.make 16 tiny));
  refuses small (Form { a = Array.make 9 tiny; b = v tiny tiny tiny; c = 1. })

let named_are_fine s =
  match Quadric_shape.check s with
  | Ok () -> true
  | Error why -> Law.fail "%s" why

(* {1 Extent} *)

let ends s =
  let found = Quadric_shape.ends s in
  match (Quadrics.ends s, found) with
  | None, None -> true
  | Some (a, b, r), Some { first; second; radius } ->
      Point.equal a first && Point.equal b second && Float.equal r radius
  | _ -> false

let unbounded : Quadric_shape.t -> bool = function
  | Ellipsoid _ | Cylinder _ | Cone _ | Paraboloid _ -> false
  | Matrix _ | Form _ | Plane _ | Hyperbolic_paraboloid _
  | Hyperboloid_one_sheet _ | Hyperboloid_two_sheets _ ->
      true

let finite_iff_bounded s =
  Bool.equal (unbounded s) (not (Bounds.is_finite (Quadric_shape.bounds s)))

(* A point of the surface: at turn [a], and [k] of the way along. *)
let point_on (s : Quadric_shape.t) a k =
  let around first second r =
    let axis = Point.sub second first in
    let { Frame.u; v = w; _ } = Frame.of_dir (Dir.of_vec_or Dir.z axis) in
    let at x (d : Dir.t) = Vec.scale (r *. x) (d :> Vec.t) in
    let rim = Vec.add (at (cos a) u) (at (sin a) w) in
    Some (Point.add (Draw.move first axis k) rim)
  in
  match s with
  | Ellipsoid { center; radii } ->
      let z = (2. *. k) -. 1. in
      let r = sqrt (Float.max 0. (1. -. (z *. z))) in
      Some
        (Point.add center
           (v (radii.x *. r *. cos a) (radii.y *. r *. sin a) (radii.z *. z)))
  | Cylinder { from; until; radius } -> around from until radius
  | Cone { apex; base; radius } -> around apex base (k *. radius)
  | Paraboloid { apex; base; radius } -> around apex base (sqrt k *. radius)
  | _ -> None

(* Such a point is computed, so it may be off by a few ulp. *)
let holds_its_points (s, (a, k)) =
  match point_on s a k with
  | None -> true
  | Some q ->
      let b = Quadric_shape.bounds s in
      let size = Vec.largest (Point.sub q Point.origin) in
      Bounds.mem q (Bounds.widen (0x1p-49 *. size) b)

(* The extreme points of an ellipsoid, exactly. *)
let holds_its_poles (s : Quadric_shape.t) =
  match s with
  | Ellipsoid { center = c; radii = r } ->
      let b = Quadric_shape.bounds s in
      let within lo hi c r =
        let open Exact in
        let least = q c - q r and most = q c + q r in
        let off = q (ulp (Float.abs c +. r)) * Q.of_int 2 in
        Q.leq (q lo) least
        && Q.geq (q hi) most
        && Q.leq (least - q lo) off
        && Q.leq (q hi - most) off
      in
      within b.x0 b.x1 c.x r.x && within b.y0 b.y1 c.y r.y
      && within b.z0 b.z1 c.z r.z
  | _ -> true

(* No more than the radius beyond the ends. *)
let no_larger s =
  match Quadric_shape.ends s with
  | None -> true
  | Some { first; second; radius } ->
      let far =
        radius
        +. 0x1p-38
           *. (radius
              +. Vec.norm (Point.sub second first)
              +. Vec.norm (Point.sub first Point.origin))
      in
      let b = Quadric_shape.bounds s in
      let around = Bounds.widen far (Bounds.of_points [ first; second ]) in
      Bounds.equal (Bounds.join around b) around

(* {1 The same and not} *)

let compared (a, b) =
  let open Quadric_shape in
  equal a a
  && compare a a = 0
  && equal a b = (compare a b = 0)
  && Int.compare (compare a b) 0 = -Int.compare (compare b a) 0
  && (equal a b = String.equal (show a) (show b) || name a <> name b)

let law ?count name gen holds =
  Law.law ?count ~print:Quadrics.show_shape name gen holds

let named = Quadrics.named

let suite =
  ( "quadric shape",
    [
      Law.example "the ends and radius of an axis are checked" ends_are_checked;
      Law.example "radii are checked" radii_are_checked;
      Law.example "planes are checked" planes_are_checked;
      Law.example "matrices must be symmetric" symmetry_is_checked;
      Law.example "coefficients must be finite and all there"
        numbers_are_checked;
      law "ordinary shapes are accepted" named named_are_fine;
      law "the ends are those of the axis, if there is one" named ends;
      law "the bounds are finite where the shape is" named finite_iff_bounded;
      Law.law ~count:5000
        ~print:(fun (s, (a, k)) ->
          Printf.sprintf "%s\nat turn %h, %h" (Quadrics.show_shape s) a k)
        "the bounds hold the points of the shape"
        Gen.(
          pair named
            (pair
               (oneof
                  [
                    Draw.uniform 0. 6.3;
                    map (( *. ) (Float.pi /. 2.)) (Draw.small 4);
                  ])
               (oneof [ Draw.uniform 0. 1.; Draw.pick [ 0.; 0.5; 1. ] ])))
        holds_its_points;
      law ~count:5000 "the bounds of an ellipsoid are those of its poles" named
        holds_its_poles;
      law "the bounds reach no further than the radius from the ends" named
        no_larger;
      Law.law
        ~print:(fun (a, b) ->
          Quadrics.show_shape a ^ "\n" ^ Quadrics.show_shape b)
        "shapes are equal where they compare and print the same"
        Gen.(
          let* a = named in
          let* b = oneof [ named; return a ] in
          return (a, b))
        compared;
    ] )

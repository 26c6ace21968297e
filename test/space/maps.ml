(** Affine maps and steps to make them of. *)

open Candor_space
open Candor_oracle
open QCheck2

let of_numbers e =
  {
    Affine.xx = e.(0);
    xy = e.(1);
    xz = e.(2);
    xt = e.(3);
    yx = e.(4);
    yy = e.(5);
    yz = e.(6);
    yt = e.(7);
    zx = e.(8);
    zy = e.(9);
    zz = e.(10);
    zt = e.(11);
  }

let of_entries g = Gen.map of_numbers (Gen.array_size (Gen.return 12) g)

let affine =
  Gen.oneof
    [
      of_entries (Draw.uniform (-3.) 3.);
      of_entries (Draw.small 3);
      of_entries (Draw.signed (Draw.wide (-8.) 8.));
    ]

(* Whole numbers round nothing. *)
let whole = of_entries (Draw.small 9)

(* The last column is a sum of multiples of the others, exactly. *)
let singular =
  let open Gen in
  let number = Draw.uniform (-3.) 3. in
  let* m = of_entries (map (Draw.rounded 26) number) in
  let* j = Draw.small 3 and* k = Draw.small 3 in
  return
    {
      m with
      Affine.xz = (j *. m.xx) +. (k *. m.xy);
      yz = (j *. m.yx) +. (k *. m.yy);
      zz = (j *. m.zx) +. (k *. m.zy);
    }

let rows (m : Affine.t) =
  Exact.
    ( v (q m.xx) (q m.xy) (q m.xz),
      v (q m.yx) (q m.yy) (q m.yz),
      v (q m.zx) (q m.zy) (q m.zz) )

let determinant m =
  let a, b, c = rows m in
  Exact.(dot a (cross b c))

let step =
  let open Gen in
  oneof
    [
      map (fun v -> Transform.Translate v) (Draw.vec (Draw.uniform (-9.) 9.));
      map
        (fun v -> Transform.Scale v)
        (Draw.vec (Draw.signed (Draw.wide (-1.) 1.)));
      map (fun k -> Transform.Scale (Vec.v k k k)) (Draw.wide (-3.) 3.);
      (let* axis = oneof [ Draw.axial; Draw.unit; Draw.vec (Draw.small 3) ] in
       let axis = if Vec.largest axis = 0. then Vec.v 0. 1. 0. else axis in
       let* degrees =
         oneof [ Draw.uniform (-360.) 360.; Draw.pick [ 90.; 180.; -90.; 45. ] ]
       in
       return (Transform.Rotate { axis; degrees }));
    ]

let show_steps steps = String.concat "; " (List.map Transform.show_step steps)

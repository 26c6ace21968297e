let kernel radius weight =
  Float.Array.init
    ((2 * radius) + 1)
    (fun i -> weight (float_of_int (i - radius)))

let radius sigmas = int_of_float (Float.ceil sigmas)
let sum = Float.Array.fold_left ( +. ) 0.
let scale k = Float.Array.map (fun w -> k *. w)

(* {1 Contrast sensitivity} *)

(* A sum of Gaussians a √(π/b) e^(-π² d² / b), d in degrees. *)
let pi = Float.pi
let widest = 0.04
let blur_radius ~ppd = radius (3. *. sqrt (widest /. (2. *. pi *. pi)) *. ppd)

(* Each factor of the product of a row and a column has the root of [a √(π/b)],
   and the whole of the area's weights is the sum of squares of the rows'. *)
let blur gaussians ~ppd =
  let row (a, b) =
    kernel (blur_radius ~ppd) (fun x ->
        let d = x /. ppd in
        sqrt (a *. sqrt (pi /. b)) *. exp (-.pi *. pi *. d *. d /. b))
  in
  let rows = List.map row gaussians in
  let square row = sum row *. sum row in
  let whole = List.fold_left (fun s row -> s +. square row) 0. rows in
  List.map (scale (1. /. sqrt whole)) rows

let achromatic ~ppd = blur [ (1., 0.0047) ] ~ppd
let red_green ~ppd = blur [ (1., 0.0053) ] ~ppd
let blue_yellow ~ppd = blur [ (34.1, widest); (13.5, 0.025) ] ~ppd

(* {1 Features} *)

(* Half the peak-to-trough width of the eye's edge detector, 0.082 degrees. *)
let sigma ~ppd = 0.5 *. 0.082 *. ppd
let feature_radius ~ppd = radius (3. *. sigma ~ppd)

let feature ~ppd factor =
  let sigma = sigma ~ppd in
  kernel (feature_radius ~ppd) (fun x ->
      factor (x /. sigma) *. exp (-.x *. x /. (2. *. sigma *. sigma)))

let balanced row =
  let gains = sum (Float.Array.map (Float.max 0.) row) in
  let losses = sum (Float.Array.map (Float.min 0.) row) in
  Float.Array.map (fun w -> if w > 0. then w /. gains else -.w /. losses) row

let smooth ~ppd =
  let row = feature ~ppd (fun _ -> 1.) in
  scale (1. /. sum row) row

let edge ~ppd = balanced (feature ~ppd (fun t -> -.t))
let point ~ppd = balanced (feature ~ppd (fun t -> (t *. t) -. 1.))
let reach ~ppd = Int.max (blur_radius ~ppd) (feature_radius ~ppd)

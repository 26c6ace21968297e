let root2 = sqrt 2.

(* What rounding took from the square root of 2. *)
let root2_tail = Float.fma (-.root2) root2 2. /. (2. *. root2)

(* erfc bears the error of x/√2 magnified by x²: the step to the exact quotient
   is taken by the derivative. *)
let upper x =
  if Float.abs x > 40. then if x > 0. then 0. else 1.
  else
    let z = x /. root2 in
    let off = (Float.fma (-.z) root2 x -. (z *. root2_tail)) /. root2 in
    let slope = 2. /. sqrt Float.pi *. exp (-.(z *. z)) in
    0.5 *. (Float.erfc z -. (off *. slope))

let cdf x = upper (-.x)

(* The algorithm's three quotients, constant terms first. *)

let ratio above below r =
  let value cs = List.fold_right (fun c rest -> c +. (r *. rest)) cs 0. in
  value above /. value below

let central =
  ratio
    [
      3.3871328727963666080;
      1.3314166789178437745e2;
      1.9715909503065514427e3;
      1.3731693765509461125e4;
      4.5921953931549871457e4;
      6.7265770927008700853e4;
      3.3430575583588128105e4;
      2.5090809287301226727e3;
    ]
    [
      1.;
      4.2313330701600911252e1;
      6.8718700749205790830e2;
      5.3941960214247511077e3;
      2.1213794301586595867e4;
      3.9307895800092710610e4;
      2.8729085735721942674e4;
      5.2264952788528545610e3;
    ]

let near =
  ratio
    [
      1.42343711074968357734;
      4.63033784615654529590;
      5.76949722146069140550;
      3.64784832476320460504;
      1.27045825245236838258;
      2.41780725177450611770e-1;
      2.27238449892691845833e-2;
      7.74545014278341407640e-4;
    ]
    [
      1.;
      2.05319162663775882187;
      1.67638483018380384940;
      6.89767334985100004550e-1;
      1.48103976427480074590e-1;
      1.51986665636164571966e-2;
      5.47593808499534494600e-4;
      1.05075007164441684324e-9;
    ]

let far =
  ratio
    [
      6.65790464350110377720;
      5.46378491116411436990;
      1.78482653991729133580;
      2.96560571828504891230e-1;
      2.65321895265761230930e-2;
      1.24266094738807843860e-3;
      2.71155556874348757815e-5;
      2.01033439929228813265e-7;
    ]
    [
      1.;
      5.99832206555887937690e-1;
      1.36929880922735805310e-1;
      1.48753612908506148525e-2;
      7.86869131145613259100e-4;
      1.84631831751005468180e-5;
      1.42151175831644588870e-7;
      2.04426310338993978564e-15;
    ]

(* The upper quantile of 0 < p <= 1/2. *)
let upper_quantile p =
  let q = 0.5 -. p in
  if q <= 0.425 then q *. central (0.180625 -. (q *. q))
  else
    let r = sqrt (-.log p) in
    if r <= 5. then near (r -. 1.6) else far (r -. 5.)

let quantile p =
  if not (p >= 0. && p <= 1.) then nan
  else if p = 0. then neg_infinity
  else if p = 1. then infinity
  else if p <= 0.5 then -.upper_quantile p
  else upper_quantile (1. -. p)

open Candor_space
open Candor_colour
open Candor_optics
open Candor_oracle

let down = Rgb.v 0.25 1. 0.
let up = Rgb.v 0.75 0. 3.
let gradient = Sky.compile (Gradient { down; up })

let upright =
  QCheck2.Gen.map3 Vec.v
    (Draw.signed (Draw.wide (-20.) (-5.)))
    (Draw.signed (Draw.uniform 0.5 2.))
    (Draw.signed (Draw.wide (-20.) (-5.)))

let directions = QCheck2.Gen.(oneof [ upright; bind Draw.unit Draw.stretched ])
let law name f = Law.law ~print:Draw.show_vec name directions f

let linear (d : Vec.t) =
  let s = ((d.y /. Vec.norm d) +. 1.) /. 2. and c = gradient d in
  Near.close c.r (0.25 +. (0.5 *. s))
  && Near.close c.g (1. -. s)
  && Near.close c.b (3. *. s)

let ends () =
  let check name expected d = Near.rgb ~within:0. name expected (gradient d) in
  check "straight up" up (Vec.v 0. 3. 0.);
  check "straight down" down (Vec.v 0. (-0.1) 0.);
  check "level" (Rgb.v 0.5 0.5 1.5) (Vec.v 7. 0. (-2.))

let suite =
  ( "sky",
    [
      law "a uniform sky is the same everywhere" (fun d ->
          Rgb.equal (Sky.compile (Uniform up) d) up);
      law "a gradient is linear in the direction's y" linear;
      Law.example "a gradient's ends and middle" ends;
      law "a gradient is never negative" (fun d ->
          let { Rgb.r; g; b } = gradient d in
          r >= 0. && g >= 0. && b >= 0.);
      law "the length of a direction does not count" (fun d ->
          List.for_all
            (fun k -> Rgb.equal (gradient d) (gradient (Vec.scale k d)))
            [ 2.; 0x1p40; 0x1p-40 ]);
    ] )

open Candor_colour
open Candor_oracle
open QCheck2

let rgb = Gen.map3 Rgb.v Draw.coordinate Draw.coordinate Draw.coordinate
let odd = Draw.pick [ nan; infinity; neg_infinity; 0.; -0.; 1.; 1e300 ]
let odd_rgb = Gen.map3 Rgb.v odd odd odd
let law name gen = Law.law ~print:Rgb.show name gen
let parts (c : Rgb.t) = [ c.r; c.g; c.b ]

let of_parts = function
  | [ r; g; b ] -> Rgb.v r g b
  | _ -> invalid_arg "three parts"

let law2 name f =
  Law.law
    ~print:(fun (a, b) -> Rgb.show a ^ Rgb.show b)
    name (Gen.pair rgb rgb)
    (fun (a, b) -> f a b)

let each f a b = of_parts (List.map2 f (parts a) (parts b))

let suite =
  ( "rgb",
    [
      law "black is the identity of add" rgb (fun c ->
          Rgb.equal (Rgb.add c Rgb.black) c && Rgb.equal (Rgb.add Rgb.black c) c);
      law "white is the identity of mul" rgb (fun c ->
          Rgb.equal (Rgb.mul c Rgb.white) c && Rgb.equal (Rgb.mul Rgb.white c) c);
      law2 "add, mul and scale go component by component" (fun a b ->
          Rgb.equal (Rgb.add a b) (each ( +. ) a b)
          && Rgb.equal (Rgb.mul a b) (each ( *. ) a b)
          && Rgb.equal (Rgb.scale a.r b) (Rgb.mul (Rgb.grey a.r) b));
      law "grey has three equal components" rgb (fun c ->
          Rgb.equal (Rgb.grey c.r) (Rgb.v c.r c.r c.r));
      law "black means that every component is zero, of either sign" odd_rgb
        (fun c -> Rgb.is_black c = List.for_all (fun x -> x = 0.) (parts c));
      law "finite means that every component is" odd_rgb (fun c ->
          Rgb.is_finite c = List.for_all Float.is_finite (parts c));
      law "the largest component is one of them and none is above" rgb (fun c ->
          let m = Rgb.largest c in
          List.mem m (parts c) && List.for_all (fun x -> x <= m) (parts c));
      law2 "the greater of two is so in each component" (fun a b ->
          Rgb.equal (Rgb.greater a b) (each Float.max a b));
      law2 "equality and order agree" (fun a b ->
          Rgb.equal a b = (Rgb.compare a b = 0) && Rgb.compare a a = 0);
    ] )

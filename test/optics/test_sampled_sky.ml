open Candor_space
open Candor_colour
open Candor_scene
open Candor_optics
open Candor_sample
open Candor_oracle
open QCheck2

(* The [k]-th random number of case [i]. *)
let uniform i k =
  let key = Key.v ~seed:11 ~x:0 ~y:0 ~sample:i ~bounce:0 Film in
  Key.float (Key.derive key k)

let made texels =
  match Sampled_sky.make texels with
  | Some sky -> sky
  | None -> Alcotest.fail "not black, but no distribution"

let texels width height f =
  Texels.init ~width ~height (fun x y -> Rgb.scale (f x y) (Rgb.v 1. 0.5 0.25))

(* A bright spot, a dim upper half and a black lower one. *)
let spot =
  texels 8 6 (fun x y ->
      if (x, y) = (5, 1) then 500. else if y < 3 then 0.1 else 0.)

let at_seam = texels 8 6 (fun x y -> if (x, y) = (7, 3) then 1. else 0.)
let at_top = texels 8 6 (fun x y -> if (x, y) = (2, 0) then 1. else 0.)

let at_bottom =
  texels 7 5 (fun x y -> if y = 4 then float_of_int (x mod 3) else 0.)

let wavy = texels 9 5 (fun x y -> float_of_int (((x * 5) + (y * 7)) mod 11))

let pictures =
  [
    ("a spot", spot);
    ("the seam", at_seam);
    ("the top", at_top);
    ("the bottom", at_bottom);
    ("all over", wavy);
    ("one texel", texels 1 1 (fun _ _ -> 3.));
    ("one row", texels 6 1 (fun x _ -> float_of_int x));
    ("one column", texels 1 6 (fun _ y -> float_of_int y));
  ]

let each f = List.iter (fun (name, t) -> f name t (made t)) pictures

(* {1 Bins}: half a texel each way, so that cells consist of whole ones. *)

let direction u fall =
  let turn = 2. *. Float.pi *. (u -. 0.5) and s = sin fall in
  Dir.of_vec_or Dir.y (Vec.v (s *. sin turn) (cos fall) (-.s *. cos turn))

let columns t = 2 * Texels.width t
let rows t = 2 * Texels.height t
let part i n = float_of_int i /. float_of_int n

let middle t i =
  let half = (0.5 /. float_of_int (columns t), 0.5 /. float_of_int (rows t)) in
  direction
    (part (i mod columns t) (columns t) +. fst half)
    (Float.pi *. (part (i / columns t) (rows t) +. snd half))

let solid_angle t i =
  let k = i / columns t in
  let height j = cos (Float.pi *. part j (rows t)) in
  2. *. Float.pi *. part 1 (columns t) *. (height k -. height (k + 1))

let bin t (d : Dir.t) =
  let { Vec.x; y; z } = (d :> Vec.t) in
  let u = 0.5 +. (atan2 x (-.z) /. (2. *. Float.pi)) in
  let fall = acos (Float.min 1. (Float.max (-1.) y)) /. Float.pi in
  let cell n x = Int.min (n - 1) (int_of_float (x *. float_of_int n)) in
  (cell (rows t) fall * columns t) + cell (columns t) u

let bins t = columns t * rows t

let chances t sky =
  Array.init (bins t) (fun i ->
      Sampled_sky.density sky (middle t i) *. solid_angle t i)

let take sky i = Sampled_sky.sample sky ~u:(uniform i 0) ~v:(uniform i 1)

let whole () =
  each (fun name t sky ->
      Near.float ~within:1e-12 name 1.
        (Array.fold_left ( +. ) 0. (chances t sky)))

let count = 30_000

(* How many standard deviations chi-square is from its mean. Bins that expect
   few are left out: they hold a hundredth of all at most. *)
let deviation counts expected =
  let term (sum, freedom, few) n e =
    if e < 8. then (sum, freedom, few +. e)
    else (sum +. (((float_of_int n -. e) ** 2.) /. e), freedom +. 1., few)
  in
  let sum, freedom, few =
    Seq.fold_left2 term (0., -1., 0.) (Array.to_seq counts)
      (Array.to_seq expected)
  in
  if few > 0.01 *. float_of_int count then Alcotest.fail "too many small bins";
  (sum -. freedom) /. sqrt (2. *. freedom)

let followed () =
  each (fun name t sky ->
      let counts = Array.make (bins t) 0 in
      for i = 0 to count - 1 do
        match take sky i with
        | None -> Alcotest.failf "%s: no sample" name
        | Some { direction; _ } ->
            let b = bin t direction in
            counts.(b) <- counts.(b) + 1
      done;
      let chances = chances t sky in
      Array.iteri
        (fun i p ->
          if p = 0. && counts.(i) > 0 then
            Alcotest.failf "%s: a sample of a black cell" name)
        chances;
      let expected = Array.map (fun p -> float_of_int count *. p) chances in
      let z = deviation counts expected in
      if not (z < 6.) then Alcotest.failf "%s: %.1f deviations" name z)

(* In small steps around and down. *)
let quadrature t f =
  let n = 30 in
  let wide = n * Texels.width t and high = n * Texels.height t in
  let sum = ref 0. in
  for i = 0 to wide - 1 do
    for j = 0 to high - 1 do
      let u = (float_of_int i +. 0.5) /. float_of_int wide
      and fall = Float.pi *. (float_of_int j +. 0.5) /. float_of_int high in
      sum := !sum +. (sin fall *. f (direction u fall))
    done
  done;
  !sum *. 2. *. Float.pi *. Float.pi /. float_of_int (wide * high)

let unbiased () =
  each (fun name t sky ->
      let radiance (d : Dir.t) = (Texels.radiance t (d :> Vec.t)).g in
      let expected = quadrature t radiance in
      let sum = ref 0. and squares = ref 0. and n = float_of_int count in
      for i = 0 to count - 1 do
        match take sky i with
        | None -> ()
        | Some s ->
            let x = s.radiance.g /. s.density in
            sum := !sum +. x;
            squares := !squares +. (x *. x)
      done;
      let mean = !sum /. n in
      let variance = Float.max 0. ((!squares /. n) -. (mean *. mean)) in
      let error = sqrt (variance /. n) +. (0.0005 *. expected) in
      if Float.abs (mean -. expected) > 5. *. error then
        Alcotest.failf "%s: %g, not %g (± %g)" name mean expected error;
      if variance > 2. *. mean *. mean then
        Alcotest.failf "%s: relative variance %g" name
          (variance /. (mean *. mean)))

let size = Gen.int_range 1 6

let sparse =
  let open Gen in
  let* width = size and* height = size in
  let value = Draw.either 70 (pure 0.) (Draw.wide (-6.) 6.) in
  let+ values = array_size (pure (3 * width * height)) value in
  Texels.init ~width ~height (fun x y ->
      let at c = values.((3 * ((y * width) + x)) + c) in
      Rgb.v (at 0) (at 1) (at 2))

let unit_number =
  Gen.oneof
    [ Draw.uniform 0. (Float.pred 1.); Draw.pick [ 0.; Float.pred 1.; 0.5 ] ]

let drawn = Gen.quad sparse Draw.unit unit_number unit_number

let print (t, d, u, v) =
  Printf.sprintf "%s towards %s, u %h v %h" (Texels.show t) (Draw.show_vec d) u
    v

let law name holds = Law.law ~count:1000 ~print name drawn holds

(* The border of a lit cell is dark on it, so its radiance may round away. *)
let covered (t, d, _, _) =
  let radiance = Texels.radiance t d in
  let d = Dir.of_vec_or Dir.y d in
  match Sampled_sky.make t with
  | None -> Rgb.is_black radiance
  | Some sky ->
      let density = Sampled_sky.density sky d in
      Float.is_finite density && density >= 0.
      && (density > 0. || Rgb.largest radiance <= 1e-7)

let agrees (t, _, u, v) =
  match Sampled_sky.make t with
  | None -> not (Texels.exists (fun c -> not (Rgb.is_black c)) t)
  | Some sky -> (
      match Sampled_sky.sample sky ~u ~v with
      | None -> true
      | Some s ->
          s.density > 0.
          && Float.equal s.density (Sampled_sky.density sky s.direction)
          && Rgb.equal s.radiance (Texels.radiance t (s.direction :> Vec.t)))

let brightness (t, d, u, v) =
  let brighter =
    Texels.init ~width:(Texels.width t) ~height:(Texels.height t) (fun x y ->
        Rgb.scale 0x1p20 (Texels.get t x y))
  in
  let d = Dir.of_vec_or Dir.y d in
  match (Sampled_sky.make t, Sampled_sky.make brighter) with
  | None, None -> true
  | None, Some _ | Some _, None -> false
  | Some a, Some b -> (
      Float.equal (Sampled_sky.density a d) (Sampled_sky.density b d)
      &&
      match (Sampled_sky.sample a ~u ~v, Sampled_sky.sample b ~u ~v) with
      | None, None -> true
      | None, Some _ | Some _, None -> false
      | Some a, Some b ->
          Dir.equal a.direction b.direction
          && Float.equal a.density b.density
          && Rgb.equal (Rgb.scale 0x1p20 a.radiance) b.radiance)

let everywhere () =
  let sky = made (texels 5 4 (fun _ _ -> 7.)) in
  List.iter
    (fun d ->
      Near.float ~within:1e-14 "1/4π" (0.25 /. Float.pi)
        (Sampled_sky.density sky (Dir.of_vec_or Dir.y d)))
    [
      Vec.v 0. 1. 0.;
      Vec.v 0. (-1.) 0.;
      Vec.v 0. 0. 1.;
      Vec.v (-0.) 0. 1.;
      Vec.v 1e-9 1. 1e-9;
      Vec.v 3. (-2.) 1.;
    ]

let black () =
  Alcotest.(check bool)
    "no distribution" true
    (Option.is_none (Sampled_sky.make (texels 3 3 (fun _ _ -> 0.))))

(* The smallest caps there are: the row at a pole, of 65,536, lights half of the
   next one too. *)
let thin () =
  let high = 65536 in
  let check name row expected =
    let sky = made (texels 1 high (fun _ y -> if y = row then 1. else 0.)) in
    let whole = ref 0. in
    let n = 4000 in
    for i = 0 to n - 1 do
      match take sky i with
      | None -> ()
      | Some s -> whole := !whole +. (1. /. s.density)
    done;
    (* The mean of 1/density is the solid angle of the lit cells. *)
    let found = !whole /. float_of_int n in
    if Float.abs (found -. expected) > 0.1 *. expected then
      Alcotest.failf "%s: %g, not %g" name found expected
  in
  let angle = 1.5 *. Float.pi /. float_of_int high in
  let cap = Float.pi *. angle *. angle in
  check "top" 0 cap;
  check "bottom" (high - 1) cap

let suite =
  ( "sampled skies",
    [
      Law.example "densities integrate to 1" whole;
      Law.example "samples are as dense as they say, also at poles" followed;
      Law.example "radiance over density has the integral as its mean" unbiased;
      law "the density is positive wherever there is light" covered;
      law "a sample's density and radiance are those of its direction" agrees;
      law "how bright all is does not count" brightness;
      Law.example "a uniform sky is sampled uniformly" everywhere;
      Law.example "a black sky has no samples" black;
      Law.example "caps of 1.5 texels in 65,536 are sampled rightly" thin;
    ] )

open Candor_oracle
open Candor_cost
open QCheck2

let drawn =
  Gen.(
    let* width = int_range 1 60
    and* height = int_range 1 60
    and* seed = int_range 0 1000
    and* pixels = int_range 1 5000 in
    return (width, height, seed, pixels))

let print (w, h, seed, n) = Printf.sprintf "%dx%d seed %d, %d" w h seed n

let make (width, height, seed, pixels) =
  Subset.make ~width ~height ~seed ~pixels

(* The block that place [x] of [n] is in, if there are [blocks]. *)
let block ~blocks n x =
  List.find
    (fun i -> i * n / blocks <= x && x < (i + 1) * n / blocks)
    (List.init blocks Fun.id)

let one_of_each ((w, h, _, _) as d) =
  let s = make d in
  let ok i =
    let x, y = Subset.pixel s i in
    block ~blocks:(Subset.width s) w x = i mod Subset.width s
    && block ~blocks:(Subset.height s) h y = i / Subset.width s
  in
  List.for_all ok (List.init (Subset.count s) Fun.id)

let as_many ((w, h, _, n) as d) =
  let s = make d in
  let count = Subset.count s in
  count >= 1
  && count <= Int.max (Int.max w h) n
  && count <= w * h
  && Subset.share s = float_of_int count /. float_of_int (w * h)
  && (n < w * h || count = w * h)

(* In the mean over seeds every pixel of a block is as likely. *)
let evenly () =
  let hits = Array.make 36 0 in
  for seed = 1 to 3600 do
    let s = Subset.make ~width:6 ~height:6 ~seed ~pixels:1 in
    let x, y = Subset.pixel s 0 in
    hits.((6 * y) + x) <- hits.((6 * y) + x) + 1
  done;
  Array.iter
    (fun n -> if n < 55 || n > 150 then Alcotest.failf "%d of 100" n)
    hits

let suite =
  ( "subset",
    [
      Law.law ~count:200 ~print "one pixel of each block is taken" drawn
        one_of_each;
      Law.law ~print "there are about as many blocks as asked for" drawn as_many;
      Law.example "any pixel of a block may stand for it" evenly;
    ] )

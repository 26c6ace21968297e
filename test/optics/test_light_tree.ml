open Candor_space
open Candor_optics
open Candor_oracle
open QCheck2.Gen

let lights n =
  array_size (return n)
    (let+ at = Draw.point (Draw.snapped (Draw.uniform (-5.) 5.))
     and+ power = oneof [ Draw.uniform 0. 3.; Draw.pick [ 0.; 1. ] ] in
     let high = Point.add at (Vec.v 0.5 0.25 0.) in
     { Light_tree.bounds = Bounds.v at high; power })

let case =
  let* n = oneof [ int_range 1 40; int_range 100 400 ] in
  let* lights = lights n in
  let* from = Draw.point (Draw.snapped (Draw.uniform (-9.) 9.)) in
  let* u = Draw.uniform 0. (Float.pred 1.) and* e = int_range (-300) 300 in
  return (lights, from, u, e)

let show (lights, from, u, e) =
  Printf.sprintf "%d lights from %s, %h, times 2^%d" (Array.length lights)
    (Draw.show_point from) u e

let leaves tree n from =
  List.init n (fun i -> Light_tree.find tree ~from i)
  |> List.sort_uniq (fun (a : Light_tree.leaf) (b : Light_tree.leaf) ->
      Int.compare a.first b.first)

let whole (lights, from, u, _) =
  let n = Array.length lights in
  let tree = Light_tree.make lights in
  let order = Array.copy (Light_tree.order tree) in
  Array.sort Int.compare order;
  let leaves = leaves tree n from in
  let sum =
    List.fold_left
      (fun sum (l : Light_tree.leaf) -> sum +. l.probability)
      0. leaves
  in
  let total =
    List.fold_left (fun n (l : Light_tree.leaf) -> n + l.count) 0 leaves
  in
  let one = Light_tree.sample tree ~from u in
  let same = Light_tree.find tree ~from one.first in
  order = Array.init n Fun.id
  && total = n
  && Near.close ~within:1e-12 sum 1.
  && one.probability > 0. && 0. <= one.rest && one.rest < 1.
  && { one with rest = 0. } = same

let often () =
  let rand = Random.State.make [| 5 |] in
  let lights = generate1 ~rand (lights 200) and from = Point.v 1. 2. 3. in
  let tree = Light_tree.make lights in
  let n = 100_000 in
  let counts = Hashtbl.create 50 in
  let rests = Array.make 10 0 in
  for i = 0 to n - 1 do
    let leaf =
      Light_tree.sample tree ~from ((float_of_int i +. 0.5) /. float_of_int n)
    in
    let bin = int_of_float (leaf.rest *. 10.) in
    rests.(bin) <- rests.(bin) + 1;
    let before = Option.value (Hashtbl.find_opt counts leaf.first) ~default:0 in
    Hashtbl.replace counts leaf.first (before + 1)
  done;
  List.iter
    (fun (l : Light_tree.leaf) ->
      let seen = Option.value (Hashtbl.find_opt counts l.first) ~default:0 in
      let part = float_of_int seen /. float_of_int n in
      if Float.abs (part -. l.probability) > 1e-4 then
        Alcotest.failf "%g of samples, not %g" part l.probability)
    (leaves tree 200 from);
  Array.iter
    (fun k ->
      Near.float ~within:0.01 "what is left" 0.1
        (float_of_int k /. float_of_int n))
    rests

(* A bright group nearby is taken more often than a dim one far away. *)
let sensible () =
  let at x power =
    Array.init 20 (fun i ->
        let c = Point.v x (float_of_int i) 0. in
        { Light_tree.bounds = Bounds.v c c; power })
  in
  let near_first = Light_tree.make (Array.append (at 0. 1.) (at 100. 1.)) in
  let taken tree i =
    let rec where k =
      if (Light_tree.order tree).(k) = i then k else where (k + 1)
    in
    (Light_tree.find tree ~from:(Point.v 5. 10. 0.) (where 0)).probability
  in
  let part l tree =
    List.fold_left (fun s i -> s +. (taken tree i /. 5.)) 0. l
  in
  let first = List.init 20 Fun.id in
  let near = part first near_first in
  if not (near > 0.98) then Alcotest.failf "only %g for what is near" near;
  let dim = Light_tree.make (Array.append (at 0. 1.) (at 10. 9.)) in
  Near.float ~within:1e-12 "from the middle by power" 0.1 (part first dim)

let scaled (lights, from, u, e) =
  let k = Float.ldexp 1. e in
  let larger (l : Light_tree.light) =
    let b = l.bounds in
    {
      Light_tree.bounds =
        Bounds.v (Point.ldexp e (Bounds.low b)) (Point.ldexp e (Bounds.high b));
      power = k *. k *. l.power;
    }
  in
  let one = Light_tree.sample (Light_tree.make lights) ~from u
  and other =
    Light_tree.sample
      (Light_tree.make (Array.map larger lights))
      ~from:(Point.ldexp e from) u
  in
  one = other

let suite =
  ( "light tree",
    [
      Law.law ~count:500 ~print:show
        "leaves hold all lights and their probabilities add up to 1" case whole;
      Law.example "leaves are taken as often as they say" often;
      Law.example "what is bright and near is taken more often" sensible;
      Law.law ~count:500 ~print:show "scaling by 2^k leaves the bits" case
        scaled;
    ] )

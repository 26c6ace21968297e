type t = { width : int; height : int; values : floatarray }

let check ~width ~height =
  if width < 1 || height < 1 then
    invalid_arg "Plane: a plane has at least one pixel"

let init ~width ~height f =
  check ~width ~height;
  { width; height; values = Float.Array.init (width * height) f }

let init3 ~width ~height f =
  check ~width ~height;
  let fresh () = Float.Array.create (width * height) in
  let a = fresh () and b = fresh () and c = fresh () in
  for y = 0 to height - 1 do
    for x = 0 to width - 1 do
      let i = (y * width) + x and first, second, third = f x y in
      Float.Array.set a i first;
      Float.Array.set b i second;
      Float.Array.set c i third
    done
  done;
  let plane values = { width; height; values } in
  (plane a, plane b, plane c)

let width p = p.width
let height p = p.height
let get p i = Float.Array.get p.values i

let add p q =
  if p.width <> q.width || p.height <> q.height then
    invalid_arg "Plane.add: the sizes differ";
  { p with values = Float.Array.map2 ( +. ) p.values q.values }

(* Row [y] of [p] with its ends repeated: as often as a kernel looks beyond, and
   for the last block of {!across} besides. *)
let load row ~radius p y =
  let start = y * p.width in
  let rest = Float.Array.length row - radius - p.width in
  Float.Array.fill row 0 radius (get p start);
  Float.Array.blit p.values start row radius p.width;
  Float.Array.fill row (radius + p.width) rest (get p (start + p.width - 1))

(* Four sums at once, since each must wait for its own last addition. *)
let weigh4 kernel row x sums =
  let a = ref 0. and b = ref 0. and c = ref 0. and d = ref 0. in
  for k = 0 to Float.Array.length kernel - 1 do
    let weight = Float.Array.get kernel k and i = x + k in
    a := !a +. (weight *. Float.Array.get row i);
    b := !b +. (weight *. Float.Array.get row (i + 1));
    c := !c +. (weight *. Float.Array.get row (i + 2));
    d := !d +. (weight *. Float.Array.get row (i + 3))
  done;
  Float.Array.set sums 0 !a;
  Float.Array.set sums 1 !b;
  Float.Array.set sums 2 !c;
  Float.Array.set sums 3 !d

let across kernel p =
  let taps = Float.Array.length kernel in
  if taps land 1 = 0 then invalid_arg "Plane.across: an even kernel";
  let radius = taps / 2 in
  let row = Float.Array.create (p.width + (2 * radius) + 3) in
  let values = Float.Array.create (p.width * p.height) in
  let sums = Float.Array.create 4 in
  for y = 0 to p.height - 1 do
    load row ~radius p y;
    for block = 0 to (p.width - 1) / 4 do
      let x = 4 * block in
      weigh4 kernel row x sums;
      for i = 0 to Int.min 3 (p.width - 1 - x) do
        let at = ((x + i) * p.height) + y in
        Float.Array.set values at (Float.Array.get sums i)
      done
    done
  done;
  { width = p.height; height = p.width; values }

let rows ~first ~count p =
  if first < 0 || count < 1 || first > p.height - count then
    invalid_arg "Plane.rows: outside";
  let values = Float.Array.sub p.values (first * p.width) (count * p.width) in
  { p with height = count; values }

let stack = function
  | [] -> invalid_arg "Plane.stack: nothing"
  | top :: _ as planes ->
      if not (List.for_all (fun p -> p.width = top.width) planes) then
        invalid_arg "Plane.stack: the widths differ";
      let height = List.fold_left (fun sum p -> sum + p.height) 0 planes in
      let values = Float.Array.concat (List.map (fun p -> p.values) planes) in
      { top with height; values }

let mean p =
  Float.Array.fold_left ( +. ) 0. p.values /. float_of_int (p.width * p.height)

type box = { left : float; top : float; width : float; height : float }
type t = { at : Svg.point; anchor : Svg.anchor; says : string; kind : string }
type wish = { mark : Svg.point; clear : float; text : string; style : string }

let around (x, y) r =
  { left = x -. r; top = y -. r; width = 2. *. r; height = 2. *. r }

let apart a b =
  a.left +. a.width <= b.left
  || b.left +. b.width <= a.left
  || a.top +. a.height <= b.top
  || b.top +. b.height <= a.top

let inside outer b =
  b.left >= outer.left && b.top >= outer.top
  && b.left +. b.width <= outer.left +. outer.width
  && b.top +. b.height <= outer.top +. outer.height

let letters s =
  let start c = Char.code c land 0xc0 <> 0x80 in
  String.fold_left (fun n c -> if start c then n + 1 else n) 0 s

(* A letter is about .58 of its height wide in the page's font. *)
let box ~size (label : t) =
  let width = 0.58 *. size *. float_of_int (letters label.says) in
  let x, y = label.at in
  let left =
    match label.anchor with
    | Start -> x
    | Middle -> x -. (width /. 2.)
    | End -> x -. width
  in
  { left; top = y -. (0.8 *. size); width; height = size }

(* Sides of a mark, best first: a front falls to the right, so that there is
   room above its right and below its left. *)
let sides ~size clear : (float * float * Svg.anchor) list =
  let near = clear and far = clear +. (0.25 *. size) in
  let down = 0.8 *. size in
  [
    (near, -.near, Start);
    (-.near, near +. down, End);
    (0., -.far, Middle);
    (0., far +. down, Middle);
    (far, 0.35 *. size, Start);
    (-.far, 0.35 *. size, End);
    (-.near, -.near, End);
    (near, near +. down, Start);
  ]

let choose ~size ~within ~taken { mark = x, y; clear; text; style } =
  let candidate (dx, dy, anchor) =
    let label =
      { at = (x +. dx, y +. dy); anchor; says = text; kind = style }
    in
    let b = box ~size label in
    if inside within b && List.for_all (apart b) taken then Some (label, b)
    else None
  in
  List.find_map candidate (sides ~size clear)

let place ~size ~within ~taken wishes =
  let add (labels, taken) wish =
    match choose ~size ~within ~taken wish with
    | None -> (labels, taken)
    | Some (label, b) -> (label :: labels, b :: taken)
  in
  let labels, _ = List.fold_left add ([], taken) wishes in
  List.rev labels

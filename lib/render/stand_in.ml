type t = {
  window : Window.t;
  shown : int array; (* where in the window is what each pixel shows *)
}

let unknown = -1

(* Outwards from the pixels that have samples, a step at a time: what is as far
   is found in their order. *)
let of_map map =
  let window = Sample_map.window map in
  let width = Window.width window and height = Window.height window in
  let shown = Array.make (width * height) unknown in
  (* Those known so far, in the order in which they were found. *)
  let found = Array.make (width * height) 0 and known = ref 0 in
  let show place other =
    shown.(place) <- other;
    found.(!known) <- place;
    incr known
  in
  let has_samples i =
    Sample_map.samples map (window.x0 + (i mod width)) (window.y0 + (i / width))
    > 0
  in
  for i = 0 to (width * height) - 1 do
    if has_samples i then show i i
  done;
  let rec spread next =
    if next < !known then (
      let i = found.(next) in
      let x = i mod width and y = i / width in
      for y = Int.max 0 (y - 1) to Int.min (height - 1) (y + 1) do
        for x = Int.max 0 (x - 1) to Int.min (width - 1) (x + 1) do
          let near = (y * width) + x in
          if shown.(near) = unknown then show near shown.(i)
        done
      done;
      spread (next + 1))
  in
  spread 0;
  { window; shown }

let pixel s x y =
  let { Window.x0; y0; _ } = s.window and width = Window.width s.window in
  let i = s.shown.(((y - y0) * width) + x - x0) in
  (x0 + (i mod width), y0 + (i / width))

let window s (w : Window.t) =
  (* Local mutation: a window that grows. *)
  let grown = ref w in
  for y = w.y0 to w.y1 - 1 do
    for x = w.x0 to w.x1 - 1 do
      let x, y = pixel s x y in
      grown := Window.join !grown { x0 = x; y0 = y; x1 = x + 1; y1 = y + 1 }
    done
  done;
  !grown

open Candor_image
open Candor_render
open Candor_trace
open Candor_oracle
open Candor_scene_made
open QCheck2

(* A map with holes, and a window in it. *)
let drawn =
  let open Gen in
  let* width = int_range 1 9 and* height = int_range 1 7 in
  let* x0 = int_bound (width - 1) and* y0 = int_bound (height - 1) in
  let* x1 = int_range (x0 + 1) width and* y1 = int_range (y0 + 1) height in
  let window = { Window.x0; y0; x1; y1 } in
  let* holes = int_bound 6 in
  let count = oneof (int_range 1 5 :: List.init holes (fun _ -> pure 0)) in
  let* counts =
    array_size (pure (y1 - y0)) (array_size (pure (x1 - x0)) count)
  in
  (* One pixel has samples, whatever is drawn. *)
  let* i = int_bound (x1 - x0 - 1) and* j = int_bound (y1 - y0 - 1) in
  let+ left = int_range x0 (x1 - 1)
  and+ top = int_range y0 (y1 - 1)
  and+ right = int_range x0 (x1 - 1)
  and+ bottom = int_range y0 (y1 - 1) in
  counts.(j).(i) <- Int.max 1 counts.(j).(i);
  let part =
    {
      Window.x0 = Int.min left right;
      x1 = Int.max left right + 1;
      y0 = Int.min top bottom;
      y1 = Int.max top bottom + 1;
    }
  in
  (Sample_map.v ~width ~height ~spp:16 window counts, part)

let print (m, w) =
  Printf.sprintf "%s, %s" (Sample_map.to_string m) (Window.show w)

let law ?count name f = Law.law ?count ~print name drawn f

let places (w : Window.t) =
  List.concat
    (List.init (Window.height w) (fun j ->
         List.init (Window.width w) (fun i -> (w.x0 + i, w.y0 + j))))

let steps (x, y) (x', y') = Int.max (abs (x - x')) (abs (y - y'))

(* The first of those with samples that are nearest, row by row. *)
let nearest m place =
  let better best other =
    match best with
    | Some b when steps place b <= steps place other -> best
    | Some _ | None -> Some other
  in
  places (Sample_map.window m)
  |> List.filter (fun (x, y) -> Sample_map.samples m x y > 0)
  |> List.fold_left better None

let is_nearest (m, _) =
  let s = Stand_in.of_map m in
  List.for_all
    (fun (x, y) -> Some (Stand_in.pixel s x y) = nearest m (x, y))
    (places (Sample_map.window m))

let in_part (m, w) =
  let s = Stand_in.of_map m in
  let grown = Stand_in.window s w in
  let shown = List.map (fun (x, y) -> Stand_in.pixel s x y) (places w) in
  let reach pick of_list = of_list (List.map pick (places w @ shown)) in
  let least = List.fold_left Int.min max_int
  and most = List.fold_left Int.max 0 in
  grown
  = {
      Window.x0 = reach fst least;
      y0 = reach snd least;
      x1 = reach fst most + 1;
      y1 = reach snd most + 1;
    }

(* {1 Pictures} *)

let scene m = Test_adaptive.noisy ~size:Sample_map.(width m, height m) ()

let render ?window samples s =
  match Render.run ~domains:1 ?window ~samples (Pixel.compile s) s with
  | Some r -> r
  | None -> Alcotest.fail "the render was stopped"

let all_known m window =
  List.for_all (fun (x, y) -> Sample_map.samples m x y >= 4) (places window)

(* Each pixel is the one that stands in for it, as a map without holes has it. *)
let shows (m, w) =
  let s = scene m and window = Sample_map.window m in
  let counts =
    Array.init (Window.height window) (fun j ->
        Array.init (Window.width window) (fun i ->
            Int.max 1 (Sample_map.samples m (window.x0 + i) (window.y0 + j))))
  in
  let filled =
    Sample_map.v ~width:(Sample_map.width m) ~height:(Sample_map.height m)
      ~spp:16 window counts
  in
  let whole = render ~window (Map filled) s in
  let stand_in = Stand_in.of_map m in
  let expected x y =
    let x, y = Stand_in.pixel stand_in (w.Window.x0 + x) (w.y0 + y) in
    Picture.pixel whole.picture (x - window.x0) (y - window.y0)
  in
  let r = render ~window:w (Map m) s in
  let again = render ~window:w (Map r.map) s in
  let width = Window.width w and height = Window.height w in
  Shot.same (Picture.init ~width ~height expected) r.picture
  && Shot.same r.picture again.picture
  && r.window = w
  && List.for_all
       (fun (x, y) -> Sample_map.(samples r.map x y = samples m x y))
       (places w)
  && Sampling.tells_nothing r.sampling = not (all_known m w)

let suite =
  ( "stand-ins",
    [
      law "the nearest pixel with samples, the first of several" is_nearest;
      law "a window grows to what its pixels show" in_part;
      law ~count:40 "a render by a map shows them, in any window" shows;
    ] )

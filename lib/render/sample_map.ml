type t = {
  width : int;
  height : int;
  spp : int;
  window : Window.t;
  counts : int array array;
}

let v ~width ~height ~spp window counts = { width; height; spp; window; counts }
let window m = m.window
let width m = m.width
let height m = m.height
let spp m = m.spp
let samples m x y = m.counts.(y - m.window.y0).(x - m.window.x0)

let crop m (w : Window.t) =
  let row y =
    Array.sub
      m.counts.(w.y0 + y - m.window.y0)
      (w.x0 - m.window.x0) (Window.width w)
  in
  if w = m.window then m
  else { m with window = w; counts = Array.init (Window.height w) row }

let fold f m start =
  Array.fold_left (fun acc row -> Array.fold_left f acc row) start m.counts

let least m = fold Int.min m max_int
let empty m = fold (fun sum n -> if n = 0 then sum + 1 else sum) m 0
let most m = fold Int.max m 0
let total m = fold (fun sum n -> sum +. float_of_int n) m 0.

let contains m (w : Window.t) =
  let { Window.x0; y0; x1; y1 } = m.window in
  x0 <= w.x0 && y0 <= w.y0 && w.x1 <= x1 && w.y1 <= y1

(* {1 As text} *)

let runs row =
  Array.fold_left
    (fun runs n ->
      match runs with
      | (m, k) :: rest when m = n -> (m, k + 1) :: rest
      | runs -> (n, 1) :: runs)
    [] row
  |> List.rev

let run_to_string (n, k) =
  if k = 1 then string_of_int n else Printf.sprintf "%dx%d" n k

let to_string m =
  let { Window.x0; y0; x1; y1 } = m.window in
  let row r = String.concat " " (List.map run_to_string (runs r)) in
  String.concat "\n"
    (Printf.sprintf "candor-map 1 width %d height %d spp %d" m.width m.height
       m.spp
    :: Printf.sprintf "window %d %d %d %d" x0 y0 x1 y1
    :: Array.to_list (Array.map row m.counts))
  ^ "\n"

let ( let* ) = Result.bind
let wrong line what = Error (Printf.sprintf "line %d: %s" line what)

(* As many samples as a sampler tells apart. *)
let most_samples = 1 lsl 31

let run_of_string word =
  match List.map int_of_string_opt (String.split_on_char 'x' word) with
  | [ Some n ] when 0 <= n && n <= most_samples -> Some (n, 1)
  | [ Some n; Some k ] when 0 <= n && n <= most_samples && k >= 1 -> Some (n, k)
  | _ -> None

let words line = List.filter (( <> ) "") (String.split_on_char ' ' line)

let row_of_string number width line =
  let row = Array.make width 1 in
  let rec fill at = function
    | [] ->
        if at = width then Ok row
        else
          wrong number
            (Printf.sprintf "%d pixels, but the window is %d wide" at width)
    | word :: rest -> (
        match run_of_string word with
        | None ->
            wrong number
              (Printf.sprintf
                 "'%s': expected a number of samples, such as 16, or 16x3 for \
                  three pixels"
                 word)
        | Some (_, k) when k > width - at ->
            wrong number
              (Printf.sprintf "more pixels than the window is wide, %d" width)
        | Some (n, k) ->
            Array.fill row at k n;
            fill (at + k) rest)
  in
  fill 0 (words line)

(* What a picture can have each way. *)
let most_pixels = 65536

let header line =
  match words line with
  | [ "candor-map"; "1"; "width"; w; "height"; h; "spp"; spp ] -> (
      match List.map int_of_string_opt [ w; h; spp ] with
      | [ Some w; Some h; Some spp ]
        when 1 <= w && w <= most_pixels && 1 <= h && h <= most_pixels
             && 1 <= spp && spp <= most_samples ->
          Ok (w, h, spp)
      | _ -> wrong 1 "the size is not that of a picture")
  | "candor-map" :: version :: _ when version <> "1" ->
      wrong 1 ("version " ^ version ^ " of sample maps is not known")
  | _ -> wrong 1 "this is not a sample map, which begins with 'candor-map 1'"

let window_of_string (width, height) line =
  match words line with
  | "window" :: numbers -> (
      match List.map int_of_string_opt numbers with
      | [ Some x0; Some y0; Some x1; Some y1 ]
        when 0 <= x0 && x0 < x1 && x1 <= width && 0 <= y0 && y0 < y1
             && y1 <= height ->
          Ok { Window.x0; y0; x1; y1 }
      | _ -> wrong 2 "the window is not within the picture")
  | _ -> wrong 2 "expected 'window X0 Y0 X1 Y1'"

let rec all = function
  | [] -> Ok []
  | Ok x :: rest -> Result.map (fun rest -> x :: rest) (all rest)
  | (Error _ as e) :: _ -> e

let of_lines = function
  | first :: second :: rows ->
      let* width, height, spp = header first in
      let* window = window_of_string (width, height) second in
      let found = List.length rows and expected = Window.height window in
      if found <> expected then
        wrong
          (Int.min found expected + 3)
          (Printf.sprintf "%d rows of pixels, but the window has %d" found
             expected)
      else
        let row i = row_of_string (i + 3) (Window.width window) in
        let* rows = all (List.mapi row rows) in
        let map = v ~width ~height ~spp window (Array.of_list rows) in
        if most map = 0 then wrong 3 "no pixel has a sample" else Ok map
  | ([] | [ _ ]) as lines ->
      let* _ = header (String.concat "" lines) in
      wrong 2 "expected 'window X0 Y0 X1 Y1'"

(* The end of the last line shows that nothing is missing. *)
let of_string text =
  match List.rev (String.split_on_char '\n' text) with
  | "" :: lines -> of_lines (List.rev lines)
  | ([] | _ :: _) as lines ->
      let* _ = of_lines (List.rev lines) in
      wrong (List.length lines) "the line does not end"

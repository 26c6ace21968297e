open Candor_render
open Candor_oracle
open QCheck2

(* {1 Maps} *)

let count =
  Gen.oneof
    [ Gen.int_range 0 5; Gen.int_range 1 5000; Draw.pick [ 0; 1; 1 lsl 30 ] ]

(* Runs of pixels alike are what adaptive renders leave. *)
let row width =
  let open Gen in
  let+ a = count
  and+ b = count
  and+ cut = int_bound width
  and+ others = array_size (pure width) count
  and+ runs = bool in
  if runs then Array.init width (fun i -> if i < cut then a else b) else others

let drawn =
  let open Gen in
  let* width = int_range 1 12 and* height = int_range 1 6 in
  let* x0 = int_bound (width - 1) and* y0 = int_bound (height - 1) in
  let* x1 = int_range (x0 + 1) width and* y1 = int_range (y0 + 1) height in
  let+ counts = array_size (pure (y1 - y0)) (row (x1 - x0)) in
  if Array.for_all (Array.for_all (( = ) 0)) counts then counts.(0).(0) <- 1;
  (Sample_map.v ~width ~height ~spp:64 { Window.x0; y0; x1; y1 } counts, counts)

let print (m, _) = Sample_map.to_string m
let law ?count name f = Law.law ?count ~print name drawn f

let places (w : Window.t) =
  List.concat
    (List.init (Window.height w) (fun j ->
         List.init (Window.width w) (fun i -> (w.x0 + i, w.y0 + j))))

let same a b =
  let w = Sample_map.window a in
  w = Sample_map.window b
  && Sample_map.(width a = width b && height a = height b)
  && List.for_all
       (fun (x, y) -> Sample_map.(samples a x y = samples b x y))
       (places w)

let holds (m, counts) =
  let w = Sample_map.window m in
  let all = List.concat_map Array.to_list (Array.to_list counts) in
  List.for_all
    (fun (x, y) -> Sample_map.samples m x y = counts.(y - w.y0).(x - w.x0))
    (places w)
  && Sample_map.least m = List.fold_left Int.min max_int all
  && Sample_map.most m = List.fold_left Int.max 0 all
  && Sample_map.empty m = List.length (List.filter (( = ) 0) all)
  && Sample_map.total m = float_of_int (List.fold_left ( + ) 0 all)

let contained (m, _) =
  let w = Sample_map.window m in
  let wider =
    [
      { w with x0 = w.x0 - 1 };
      { w with y0 = w.y0 - 1 };
      { w with x1 = w.x1 + 1 };
      { w with y1 = w.y1 + 1 };
    ]
  in
  let corner = { w with x1 = w.x0 + 1; y1 = w.y0 + 1 } in
  let crop w =
    let part = Sample_map.crop m w in
    Sample_map.window part = w
    && List.for_all
         (fun (x, y) -> Sample_map.(samples part x y = samples m x y))
         (places w)
  in
  crop w && crop corner && Sample_map.contains m w
  && Sample_map.contains m corner
  && not (List.exists (Sample_map.contains m) wider)

(* {1 Texts} *)

let round_trip (m, _) =
  match Sample_map.of_string (Sample_map.to_string m) with
  | Ok found -> same m found
  | Error why -> Law.fail "%s" why

let golden () =
  Alcotest.(check string)
    "runs are written once"
    "candor-map 1 width 9 height 5 spp 64\nwindow 2 1 7 3\n4x3 5 4\n16x5\n"
    (Sample_map.to_string
       (Sample_map.v ~width:9 ~height:5 ~spp:64
          { x0 = 2; y0 = 1; x1 = 7; y1 = 3 }
          [| [| 4; 4; 4; 5; 4 |]; [| 16; 16; 16; 16; 16 |] |]))

(* The line that is wrong, or 0. *)
let named_line why =
  match Scanf.sscanf_opt why "line %d: %c" (fun line _ -> line) with
  | Some line -> line
  | None -> 0

let refused text =
  match Sample_map.of_string text with
  | Ok _ -> Law.fail "%S is taken for a map" text
  | Error why -> named_line why >= 1 || Law.fail "%S: %s" text why
  | exception e -> Law.fail "%S: %s" text (Printexc.to_string e)

let truncated (m, _) =
  let text = Sample_map.to_string m in
  List.for_all
    (fun n -> refused (String.sub text 0 n))
    (List.init (String.length text) Fun.id)

(* Whatever is done to its bytes, it is a map or the error names a line. *)
let mangled =
  let open Gen in
  let* m, _ = drawn in
  let text = Sample_map.to_string m in
  let n = String.length text in
  let odd = Draw.pick [ ' '; '\n'; 'x'; '-'; '0'; '9'; '\000'; '\255'; '.' ] in
  let change text (at, c, how) =
    let at = at mod Int.max 1 (String.length text) in
    let before = String.sub text 0 at
    and after = String.sub text at (String.length text - at) in
    let rest =
      if after = "" then "" else String.sub after 1 (String.length after - 1)
    in
    match how with
    | 0 -> before ^ String.make 1 c ^ after
    | 1 -> before ^ String.make 1 c ^ rest
    | _ -> before ^ rest
  in
  let+ changes =
    list_size (int_range 1 3) (triple (int_bound (n - 1)) odd (int_bound 2))
  in
  List.fold_left change text changes

let whole text =
  match Sample_map.of_string text with
  | Ok m -> (
      let counts = places (Sample_map.window m) in
      List.for_all (fun (x, y) -> Sample_map.samples m x y >= 0) counts
      && Sample_map.most m >= 1
      && Sample_map.contains m (Sample_map.window m)
      &&
      match Sample_map.of_string (Sample_map.to_string m) with
      | Ok again -> same m again
      | Error why -> Law.fail "%s" why)
  | Error why -> named_line why >= 1 || Law.fail "%s" why
  | exception e -> Law.fail "%s" (Printexc.to_string e)

let junk = Gen.(oneof [ string_size (int_bound 30); mangled ])

let broken () =
  let check line lines =
    let text = String.concat "\n" lines ^ "\n" in
    match Sample_map.of_string text with
    | Ok _ -> Alcotest.failf "%S is taken for a map" text
    | Error why -> Alcotest.(check int) (text ^ why) line (named_line why)
  in
  let first = "candor-map 1 width 3 height 2 spp 64"
  and second = "window 0 0 3 2" in
  let head = check 1 and window w = check 2 [ first; w; "1x3"; "1x3" ] in
  head [ "" ];
  head [ "garbage" ];
  head [ "candor-map" ];
  head [ "candor-map 2 width 3 height 2 spp 64"; second; "1x3"; "1x3" ];
  head [ "candor-map 1 width 0 height 2 spp 64"; second; "1x3"; "1x3" ];
  head [ "candor-map 1 width -3 height 2 spp 64"; second; "1x3"; "1x3" ];
  head [ "candor-map 1 width 3.5 height 2 spp 64"; second; "1x3"; "1x3" ];
  head [ "candor-map 1 width 3"; second; "1x3"; "1x3" ];
  check 2 [ first ];
  window "";
  window "windows 0 0 3 2";
  window "window 0 0 4 2";
  window "window 0 0 3 3";
  window "window -1 0 3 2";
  window "window 0 0 0 2";
  window "window 2 0 1 2";
  window "window 0 2 3 2";
  window "window 0 0 3";
  window "window 0 0 3 2 1";
  window "window 0 0 3 x";
  check 3 [ first; second ];
  check 3 [ first; second; "0x3"; "0 0x2" ];
  check 4 [ first; second; "1x3" ];
  check 5 [ first; second; "1x3"; "1x3"; "1x3" ];
  let row r = check 4 [ first; second; "1x3"; r ] in
  row "";
  row "1 1";
  row "1x2";
  row "1x4";
  row "1 1 1 1";
  row "1x2 1x2";
  row "-1x3";
  row "1x-3";
  row "1x0 1x3";
  row "1x";
  row "x3";
  row "1x3x1";
  row "1.5x3";
  row "99999999999999999999x3";
  row "4611686018427387903x3";
  row "1x4611686018427387903";
  row "1 1 one"

(* Sizes that no picture has would fill all memory, or more. *)
let enormous () =
  List.iter
    (fun n ->
      List.iter
        (fun (w, h, row) ->
          let text =
            Printf.sprintf
              "candor-map 1 width %d height %d spp 64\nwindow 0 0 %d %d\n%s\n" w
              h w h row
          in
          Alcotest.(check bool) text true (refused text))
        [ (n, 1, Printf.sprintf "1x%d" n); (1, n, "1"); (n, 1, "1") ])
    [ 65537; 1 lsl 40; max_int ];
  let largest =
    "candor-map 1 width 65536 height 65536 spp 64\n\
     window 0 0 65536 1\n\
     7x65536\n"
  in
  match Sample_map.of_string largest with
  | Ok m -> Alcotest.(check int) "the largest" 7 (Sample_map.samples m 65535 0)
  | Error why -> Alcotest.fail why

let suite =
  ( "sample maps",
    [
      law "a map holds the numbers that it is made of" holds;
      law "a map contains its window, and no wider one" contained;
      Law.example "a golden text" golden;
      law "what is written is read" round_trip;
      law ~count:300 "a text that ends too soon is refused, by its line"
        truncated;
      Law.law ~print:(Printf.sprintf "%S")
        "any text is a map or an error that names a line" junk whole;
      Law.example "the line that is wrong is named" broken;
      Law.example "no size is taken that no picture has" enormous;
    ] )

open Candor_read
open Text

let lacks ?(grouped = false) forms =
  let s = only_surface forms in
  let name (l : Lack.t) =
    match l with Bounds -> "bounds" | Inside -> "inside" | Uv -> "uv"
  in
  List.filter (Lack.is_of ~grouped s.shape) Lack.all |> List.map name

let check ?grouped forms expected =
  Alcotest.(check (list string)) forms expected (lacks ?grouped forms)

let quadric shape = Printf.sprintf "(quadric %s)" shape
let clip = "(clip (min -1 -1 -1) (max 1 1 1))"

let simple () =
  check "(sphere (center 0 0 0) (radius 1))" [];
  check "(box (min 0 0 0) (max 1 1 1))" [];
  check "(box (min 0 0 0) (max 1 0 1))" [ "inside" ];
  check "(triangle (0 0 0) (1 0 0) (0 1 0))" [ "inside" ];
  check ~grouped:true "(triangle (0 0 0) (1 0 0) (0 1 0))" [];
  check "(polygon (0 0 0) (1 0 0) (0 1 0))" [ "inside" ];
  check ~grouped:true "(polygon (0 0 0) (1 0 0) (0 1 0))" [];
  Files.with_folder (fun folder ->
      let path =
        Files.write folder "a.obj" "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3"
      in
      check (Printf.sprintf "(mesh %S)" path) []);
  check "(group (triangle (0 0 0) (1 0 0) (0 1 0)))" []

let quadrics () =
  let check shape ~whole ~clipped =
    check (quadric shape) whole;
    check (quadric (shape ^ clip)) clipped
  in
  check "(plane (normal 0 1 0) (offset 0))" ~whole:[ "bounds"; "inside" ]
    ~clipped:[ "inside" ];
  check "(ellipsoid (center 0 0 0) (radii 1 2 3))" ~whole:[ "uv" ]
    ~clipped:[ "inside"; "uv" ];
  let axial shape =
    check shape ~whole:[ "inside" ] ~clipped:[ "inside" ];
    check (shape ^ "(caps)") ~whole:[] ~clipped:[ "inside" ]
  in
  axial "(cylinder (from 0 0 0) (to 0 1 0) (radius 1))";
  axial "(cone (apex 0 0 0) (base 0 1 0) (radius 1))";
  axial "(paraboloid (apex 0 0 0) (base 0 1 0) (radius 1))";
  let endless shape =
    check
      (shape ^ "(center 0 0 0) (radii 1 1 1))")
      ~whole:[ "bounds"; "inside"; "uv" ]
      ~clipped:[ "inside"; "uv" ]
  in
  endless "(hyperbolic-paraboloid ";
  endless "(hyperboloid-one-sheet ";
  endless "(hyperboloid-two-sheets "

(* Rotated or not, of either sign, and however large: an ellipsoid is closed. *)
let written_out () =
  let form a = Printf.sprintf "(form (a %s) (b 0 0 0) (c -1))" a in
  let closed a = check (quadric (form a)) [ "bounds"; "uv" ]
  and opened a = check (quadric (form a)) [ "bounds"; "inside"; "uv" ] in
  closed "1 0 0 0 2 0 0 0 3";
  closed "-1 0 0 0 -2 0 0 0 -3";
  closed "2 1 0 1 2 1 0 1 2";
  closed "0x1p300 0x1p299 0 0x1p299 0x1p300 0 0 0 0x1p-300";
  opened "1 0 0 0 1 0 0 0 -1";
  opened "1 0 0 0 1 0 0 0 0";
  opened "0 0 0 0 1 0 0 0 1";
  opened "1 2 0 2 1 0 0 0 1";
  opened "1 0 2 0 1 0 2 0 1";
  opened "1 0 0 0 1 2 0 2 1";
  check (quadric "(matrix 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 -1)") [ "bounds"; "uv" ];
  check
    (quadric "(matrix 1 0 0 0 0 0 1 0 0 1 0 0 0 0 0 -1)")
    [ "bounds"; "inside"; "uv" ]

let minded () =
  let check material expected =
    match
      (only_surface
         (Printf.sprintf "(sphere (center 0 0 0) (radius 1) (material %s))"
            material))
        .material
    with
    | Some (Inline m) ->
        Alcotest.(check (list bool))
          material expected
          (List.map (Lack.is_minded_by m) [ Bounds; Inside; Uv ])
    | Some (Named _) | None -> Alcotest.fail material
  in
  check "(matte (color 1))" [ false; false; false ];
  check "(matte (color 1) (emission 0))" [ false; false; false ];
  check "(matte (color 1) (emission (rgb 0 0 1)))" [ true; false; false ];
  check "(emitter (radiance 1))" [ true; false; false ];
  check "(emitter (radiance 0))" [ false; false; false ];
  check "(translucent (index 1) (scattering 0) (absorption 0))"
    [ false; true; false ];
  check "(translucent (index 1) (scattering 0) (absorption 0) (emission 1))"
    [ true; true; false ]

let suite =
  ( "lack",
    [
      case "flat surfaces are closed only together with others" simple;
      case "a quadric is closed when whole, with caps where it has ends"
        quadrics;
      case "a quadric written out is closed iff it is an ellipsoid" written_out;
      case "light needs bounds, and a cloudy medium an inside" minded;
    ] )

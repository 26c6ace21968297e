open Candor_space
open Candor_colour
open Candor_effect
open Candor_oracle
open Candor_scene_made
open QCheck2

let start () =
  Alcotest.check Lit.rgb "throughput" (Rgb.v 1. 1. 1.) Path.start.throughput;
  Alcotest.(check int) "depth" 0 Path.start.depth

let share = Draw.pick [ 0.; 0.25; 0.5; 1. ]
let shares = Gen.map3 Rgb.v share share share

(* The paths of the rays behind a chain of mirrors, the last of them first. *)
let rec behind mirrors path =
  match mirrors with
  | [] -> [ path ]
  | (m : Rgb.t) :: rest ->
      let s =
        Lit.scene
          [
            Printf.sprintf
              "(box (min -9 -9 0) (max 9 9 0) (material (mirror (color (rgb %h \
               %h %h)))))"
              m.r m.g m.b;
          ]
      in
      let hit = Lit.hit s (0., 0., 5.) (0., 0., -1.) in
      let vertex = Lit.vertex ~path hit (Vec.v 0. 0. 1.) in
      let next = ref None in
      let radiance _ ~kind:_ path _ =
        next := Some path;
        Rgb.white
      in
      ignore
        (Mirror.term
           (Limit.Fixed { depth = 99; cutoff = 0. })
           radiance (Tally.make ()) vertex
          : Rgb.t);
      let further =
        match !next with Some path -> behind rest path | None -> []
      in
      further @ [ path ]

(* A black mirror ends a path. *)
let rec until_black = function
  | [] -> []
  | m :: _ when Rgb.is_black m -> []
  | m :: rest -> m :: until_black rest

let carries mirrors =
  let followed = until_black mirrors in
  match behind mirrors Path.start with
  | last :: before ->
      last.depth = List.length followed
      && List.length before = last.depth
      && Rgb.equal last.throughput (List.fold_left Rgb.mul Rgb.white followed)
  | [] -> false

let print mirrors = String.concat " " (List.map Rgb.show mirrors)

let suite =
  ( "paths",
    [
      Law.example "a path starts with throughput 1 at depth 0" start;
      Law.law ~count:300 ~print
        "a path carries the product of its mirrors, and their number"
        Gen.(list_size (int_bound 6) shares)
        carries;
      Law.law ~count:300 ~print:Drawn.show
        "a camera ray enters with the path that starts" (Drawn.scene Round)
        (fun s ->
          match fst (Lit.events s (0, 0)) with
          | Enter { kind; throughput; _ } :: _ ->
              String.equal kind "camera"
              && Rgb.equal throughput Path.start.throughput
          | _ -> false);
    ] )

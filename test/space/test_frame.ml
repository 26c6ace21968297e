open Candor_space
open Candor_oracle
open Places

let orthonormal a =
  match Dir.of_vec a with
  | None -> true
  | Some w ->
      let f = Frame.of_dir w in
      let u = (f.u :> Vec.t) and v = (f.v :> Vec.t) and w' = (f.w :> Vec.t) in
      Dir.equal f.w w
      && List.for_all
           (fun (a, b) -> near 0x1p-49 (Vec.dot a b) 0.)
           [ (u, v); (v, w'); (w', u) ]
      && List.for_all (fun a -> near 0x1p-49 (Vec.norm a) 1.) [ u; v; w' ]
      && vec_near 0x1p-49 (Vec.cross u v) w'

let poles () =
  List.iter
    (fun a -> Alcotest.(check bool) (show a) true (orthonormal a))
    [
      Vec.v 0. 0. (-1.);
      Vec.v 0. 0. 1.;
      Vec.v 1e-17 0. (-1.);
      Vec.v 0. 1e-8 (-.(1. -. 1e-14));
      Vec.v 1e-300 1e-300 (-1.);
      Vec.v 1. 0. 0.;
      Vec.v 1. 0. (-0.);
      Vec.v 0. (-1.) (-5e-324);
    ]

(* A hair's breadth beside a pole, down to nothing. *)
let near_pole =
  let open QCheck2.Gen in
  let aside = Draw.signed (Draw.wide (-18.) 0.) in
  let+ x = aside and+ y = aside and+ z = Draw.nudged Draw.sign in
  Vec.v x y z

let suite =
  ( "frames",
    [
      Law.law ~count:20000 ~print:show
        "three unit directions at right angles, right-handed" vec orthonormal;
      Law.law ~count:20000 ~print:show
        "G16: frames next to the poles are orthonormal" near_pole orthonormal;
      Law.example "G16: frames at the poles and on the axes are orthonormal"
        poles;
    ] )

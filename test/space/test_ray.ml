open Candor_space
open Candor_oracle

let starts_nowhere (r : Ray.t) =
  let again = Ray.v r.origin r.direction in
  again.departure = Ray.Nowhere
  && Point.equal (Ray.at again 0.) r.origin
  && Point.equal (Ray.at again 2.) (Point.along r.origin r.direction 2.)

let sides () =
  List.iter
    (fun s ->
      Alcotest.(check bool)
        "twice is once" true
        (Side.opposite (Side.opposite s) = s && Side.opposite s <> s))
    [ Side.Outside; Inside ]

let suite =
  ( "rays",
    [
      Law.law ~print:Draw.show_ray "a ray starts nowhere, at its origin"
        Draw.ray starts_nowhere;
      Law.example "there are two sides" sides;
    ] )

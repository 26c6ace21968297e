open Candor_space

type t = { corners : Point.t list; triangles : Triangle.t list }
[@@deriving show, eq, ord]

let make corners =
  match corners with
  | [ a; b; c ] ->
      Result.map
        (fun triangle -> { corners; triangles = [ triangle ] })
        (Triangle.make { a; b; c })
  | _ -> Error "a polygon needs at least three corners"

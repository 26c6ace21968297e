open Candor_space
open Decode
open Fields

let point =
  Quantity.numbers "X Y Z" Rule.length
  |> map (fun a -> Point.v a.(0) a.(1) a.(2))

let vector =
  Quantity.numbers "X Y Z" Rule.length |> map (fun a -> Vec.v a.(0) a.(1) a.(2))

let not_zero v =
  if Vec.equal v Vec.zero then Error "a direction must not be zero" else Ok v

let direction = vector |> check not_zero
let length name = Quantity.scalar name Rule.length
let size name = Quantity.scalar name Rule.size

let radii =
  Quantity.numbers "A B C" Rule.size |> map (fun a -> Vec.v a.(0) a.(1) a.(2))

let bounds =
  fields
    (let+ min = field "min" point and+ max = field "max" point in
     Bounds.v min max)

type t = Outside | Inside [@@deriving show, eq, ord]

let opposite = function Outside -> Inside | Inside -> Outside

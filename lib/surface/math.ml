type t = Stable | Textbook [@@deriving show, eq, ord]

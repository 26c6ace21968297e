type t = Ambient | Direct | Shadows | Mirror [@@deriving show, eq, ord]

let all = [ Ambient; Direct; Shadows; Mirror ]

let name = function
  | Ambient -> Ambient.name
  | Direct -> Direct.name
  | Shadows -> Shadows.name
  | Mirror -> Mirror.name

let meaning = function
  | Ambient -> Ambient.meaning
  | Direct -> Direct.meaning
  | Shadows -> Shadows.meaning
  | Mirror -> Mirror.meaning

let calls = function
  | Ambient -> Ambient.calls
  | Direct -> Direct.calls
  | Shadows -> Shadows.calls
  | Mirror -> Mirror.calls

let rays = function
  | Ambient | Direct -> None
  | Shadows -> Some Tally.Shadow_rays
  | Mirror -> Some Tally.Mirror_rays

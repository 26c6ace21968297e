type t = {
  mutable t : float;
  least : float;
  mutable tests : float;
  mutable careful : float;
}

let v ?(least = 0.) limit = { t = limit; least; tests = 0.; careful = 0. }
let[@inline] tested cursor = cursor.tests <- cursor.tests +. 1.
let[@inline] careful cursor = cursor.careful <- cursor.careful +. 1.

let[@inline] take cursor t contact =
  if t > cursor.least && t <= cursor.t && t < infinity then (
    cursor.t <- t;
    contact)
  else Contact.none

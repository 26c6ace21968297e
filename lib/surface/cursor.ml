type t = { mutable t : float }

let[@inline] take cursor t contact =
  if t > 0. && t <= cursor.t && t < infinity then (
    cursor.t <- t;
    contact)
  else Contact.none

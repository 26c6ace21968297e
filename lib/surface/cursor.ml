type t = {
  mutable t : float;
  least : float;
  time : float;
  mutable tests : float;
  mutable careful : float;
  mutable last : float;
}

let v ?(least = 0.) ?(time = 0.) limit =
  { t = limit; least; time; tests = 0.; careful = 0.; last = -1. }

let[@inline] tested cursor = cursor.tests <- cursor.tests +. 1.

let[@inline] careful cursor =
  if cursor.last < cursor.tests then (
    cursor.last <- cursor.tests;
    cursor.careful <- cursor.careful +. 1.)

let[@inline] take cursor t contact =
  if t > cursor.least && t <= cursor.t && t < infinity then (
    cursor.t <- t;
    contact)
  else Contact.none

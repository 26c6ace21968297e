(** The price list as a page to look at. *)

val html : Price.t -> string
(** [html p] is [p] as one HTML 5 page: what to choose, error plotted against
    seconds, the table, what lights and effects cost, what is paid for nothing,
    the picture and its errors at every rung, and where time and samples go. It
    needs no other file, no script and no network, is readable from 360 pixels
    up, light or dark, and prints. Total: whatever is missing, zero, infinite or
    not a number in [p], the page is well formed. *)

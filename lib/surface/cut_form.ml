type t = Piece.t

let make = Piece.make

let meet (q : t) ray left cursor =
  let found =
    if Contact.is_none left || Contact.part left <> 0 then
      Plain_form.meet q ray cursor
    else Plain_form.meet_again q ray (Contact.side left) cursor
  in
  let add found end_ = Piece.later found (Disk.meet q ray end_ left cursor) in
  if Array.length q.disks = 0 then found else Array.fold_left add found q.disks

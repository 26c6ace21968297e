type t = { mutable tests : float; mutable careful : float }

let make () = { tests = 0.; careful = 0. }

let add (cursor : Cursor.t) effort =
  effort.tests <- effort.tests +. cursor.tests;
  effort.careful <- effort.careful +. cursor.careful

let tests effort = int_of_float effort.tests
let careful effort = int_of_float effort.careful

let sum efforts =
  let total of_ = List.fold_left (fun n e -> n +. of_ e) 0. efforts in
  { tests = total (fun e -> e.tests); careful = total (fun e -> e.careful) }

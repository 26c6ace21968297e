open Candor_render

let counts () =
  List.iter
    (fun (n, expected) ->
      Alcotest.(check string) expected expected (Plural.count n "path"))
    [
      (0, "0 paths"); (1, "1 path"); (2, "2 paths"); (1000000, "1000000 paths");
    ]

let suite = ("plural", [ Alcotest.test_case "one thing has no s" `Quick counts ])

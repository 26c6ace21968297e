let () = Alcotest.run "sample" [ Test_key.suite; Test_pattern.suite ]

let () = Alcotest.run "cost" (Test_absent.suites @ [ Test_forced.suite ])

let () =
  Alcotest.run "effect"
    [
      Test_path.suite;
      Test_event.suite;
      Test_tally.suite;
      Test_term.suite;
      Test_reason.suite;
      Test_catalogue.suite;
      Test_plan.suite;
      Test_ambient.suite;
      Test_direct.suite;
      Test_shadows.suite;
      Test_mirror.suite;
    ]

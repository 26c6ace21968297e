let () =
  Sys.set_signal Sys.sigpipe Signal_ignore;
  Alcotest.run "command"
    [
      Test_usage.suite;
      Test_render.suite;
      Test_targets.suite;
      Test_trouble.suite;
      Test_interrupt.suite;
      Test_check.suite;
      Test_explain.suite;
      Test_cost.suite;
      Test_trace.suite;
      Test_cast.suite;
      Test_diff.suite;
    ]

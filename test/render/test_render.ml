let () =
  (* A reader that goes away is an error to report. *)
  Sys.set_signal Sys.sigpipe Signal_ignore;
  Alcotest.run "render"
    [
      Test_clock.suite;
      Test_plural.suite;
      Test_rows.suite;
      Test_window.suite;
      Test_row.suite;
      Test_sampling.suite;
      Test_part.suite;
      Test_allocation.suite;
      Test_forecast.suite;
      Test_jury.suite;
      Test_adaptive.suite;
      Test_sample_map.suite;
      Test_stand_in.suite;
      Test_pace.suite;
      Test_picture.suite;
      Test_json.suite;
      Test_ledger.suite;
      Test_cut_off.suite;
      Test_output.suite;
      Test_progress.suite;
    ]

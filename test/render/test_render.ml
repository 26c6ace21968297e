let () =
  (* A reader that goes away is an error to report. *)
  Sys.set_signal Sys.sigpipe Signal_ignore;
  Alcotest.run "render"
    [
      Test_rows.suite;
      Test_picture.suite;
      Test_json.suite;
      Test_ledger.suite;
      Test_cut_off.suite;
      Test_output.suite;
      Test_progress.suite;
    ]

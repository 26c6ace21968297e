let () =
  Alcotest.run "price"
    [
      Test_amount.suite;
      Test_base64.suite;
      Test_markup.suite;
      Test_svg.suite;
      Test_scale.suite;
      Test_labels.suite;
      Test_ladder.suite;
      Test_heat.suite;
      Test_wording.suite;
      Test_plot.suite;
      Test_page.suite;
    ]

let () =
  Alcotest.run "price"
    [
      Test_budget.suite;
      Test_subset.suite;
      Test_measure.suite;
      Test_pair.suite;
      Test_power_law.suite;
      Test_front.suite;
      Test_without.suite;
      Test_variant.suite;
      Test_verdict.suite;
      Test_survey.suite;
      Test_appraisal.suite;
      Test_price_text.suite;
    ]

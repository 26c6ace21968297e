let () =
  Alcotest.run "number"
    [
      Test_error_free.suite;
      Test_neighbour.suite;
      Test_double_double.suite;
      Test_expansion.suite;
      Test_running_sum.suite;
      Test_running_variance.suite;
      Test_angle.suite;
      Test_normal.suite;
      Test_student.suite;
      Test_chi_square.suite;
      Test_binomial.suite;
    ]

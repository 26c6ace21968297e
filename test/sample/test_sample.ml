let () =
  Alcotest.run "sample"
    [
      Test_key.suite;
      Test_pattern.suite;
      Test_sobol.suite;
      Test_sampler.suite;
      Test_warp.suite;
      Test_distribution.suite;
      Test_spherical_triangle.suite;
    ]

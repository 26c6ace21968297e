let () =
  Alcotest.run "optics"
    [
      Test_aim.suite;
      Test_colour_at.suite;
      Test_illumination.suite;
      Test_lobes.suite;
      Test_refraction.suite;
      Test_sky.suite;
    ]

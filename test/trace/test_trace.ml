let () =
  Alcotest.run "trace"
    [
      Test_pixel.suite;
      Test_radiance.suite;
      Test_pictures.suite;
      Test_laws.suite;
      Test_scenes.suite;
      Test_meshes.suite;
      Test_hard.suite;
    ]

let () =
  Alcotest.run "media"
    [
      Test_foggy.suite;
      Test_bodies.suite;
      Test_skies.suite;
      Test_lens.suite;
      Test_moved.suite;
      Test_smooth_mesh.suite;
    ]

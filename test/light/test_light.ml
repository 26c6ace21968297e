let () =
  Alcotest.run "light"
    [
      Test_furnace.suite;
      Test_lights.suite;
      Test_glass.suite;
      Test_rooms.suite;
      Test_gloss.suite;
      Test_caustics.suite;
      Test_prism.suite;
    ]

let () =
  Alcotest.run "scene"
    [
      Test_place.suite;
      Test_material.suite;
      Test_description.suite;
      Test_assembly.suite;
    ]

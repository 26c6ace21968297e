let () =
  Alcotest.run "scene"
    [
      Test_place.suite;
      Test_texels.suite;
      Test_texture.suite;
      Test_material.suite;
      Test_light.suite;
      Test_camera.suite;
      Test_description.suite;
      Test_assembly.suite;
      Test_emitters.suite;
    ]

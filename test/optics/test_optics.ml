let () =
  Alcotest.run "optics"
    [
      Test_aim.suite;
      Test_area_lights.suite;
      Test_coat.suite;
      Test_colour_at.suite;
      Test_ellipsoid_target.suite;
      Test_enclosure.suite;
      Test_gloss.suite;
      Test_illumination.suite;
      Test_light_target.suite;
      Test_light_tree.suite;
      Test_lobes.suite;
      Test_medium.suite;
      Test_microfacet.suite;
      Test_noise.suite;
      Test_refraction.suite;
      Test_sampled_sky.suite;
      Test_scattering.suite;
      Test_skin.suite;
      Test_sky.suite;
    ]

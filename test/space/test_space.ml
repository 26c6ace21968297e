let () =
  Alcotest.run "space"
    [
      Test_vec.suite;
      Test_point.suite;
      Test_dir.suite;
      Test_frame.suite;
      Test_bounds.suite;
      Test_unrounded.suite;
      Test_affine.suite;
      Test_wide_affine.suite;
      Test_object_ray.suite;
      Test_transform.suite;
      Test_side.suite;
      Test_ray.suite;
    ]

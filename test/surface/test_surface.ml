let () =
  Alcotest.run "surface"
    [
      Test_sphere.suite;
      Test_box.suite;
      Test_triangle.suite;
      Test_polygon.suite;
      Test_form.suite;
      Test_half_space.suite;
      Test_quadric.suite;
      Test_bvh.suite;
      Test_queries.suite;
      Test_hit.suite;
    ]

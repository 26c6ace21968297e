let () =
  Alcotest.run "surface"
    [
      Test_sphere.suite;
      Test_box.suite;
      Test_triangle.suite;
      Test_polygon.suite;
      Test_form.suite;
      Test_half_space.suite;
      Test_cut_form.suite;
      Test_quadric.suite;
      Test_bvh.suite;
      Test_queries.suite;
      Test_hit.suite;
      Test_reach.suite;
      Test_contact.suite;
      Test_cursor.suite;
      Test_root.suite;
      Test_flat.suite;
      Test_border.suite;
      Test_filling.suite;
      Test_local.suite;
      Test_quadric_shape.suite;
      Test_box_array.suite;
      Test_tree.suite;
    ]

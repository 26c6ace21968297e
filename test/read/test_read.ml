let () =
  Alcotest.run "read"
    [
      Test_spelling.suite;
      Test_number.suite;
      Test_quote.suite;
      Test_rule.suite;
      Test_span.suite;
      Test_located.suite;
      Test_outline.suite;
      Test_source.suite;
      Test_forms.suite;
      Test_excerpt.suite;
      Test_notes.suite;
      Test_error.suite;
      Test_decode.suite;
      Test_camera_decoder.suite;
      Test_light_decoder.suite;
      Test_material_decoder.suite;
      Test_transform_decoder.suite;
      Test_quadric_decoder.suite;
      Test_surface_decoder.suite;
      Test_top_level.suite;
      Test_cycles.suite;
      Test_layout.suite;
      Test_scene_printer.suite;
      Test_scene_file.suite;
    ]

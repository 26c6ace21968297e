let () =
  Alcotest.run "image"
    [
      Test_picture.suite;
      Test_raster.suite;
      Test_ppm.suite;
      Test_png.suite;
      Test_pfm.suite;
      Test_picture_file.suite;
      Test_comparison.suite;
    ]

let () =
  Alcotest.run "image"
    [
      Test_extent.suite;
      Test_picture.suite;
      Test_raster.suite;
      Test_scan.suite;
      Test_ppm.suite;
      Test_deflate.suite;
      Test_png_chunk.suite;
      Test_png_filter.suite;
      Test_png.suite;
      Test_pfm.suite;
      Test_picture_file.suite;
      Test_comparison.suite;
      Test_plane.suite;
      Test_flip_colour.suite;
      Test_flip_filter.suite;
      Test_magma.suite;
      Test_flip.suite;
    ]

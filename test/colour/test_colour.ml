let () = Alcotest.run "colour" [ Test_rgb.suite; Test_display.suite ]

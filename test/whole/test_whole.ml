let () =
  Alcotest.run "whole"
    [
      Test_visibility.suite;
      Test_shadows.suite;
      Test_contact.suite;
      Test_mesh.suite;
      Test_changed.suite;
      Test_drawn.suite;
    ]

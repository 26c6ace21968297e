open Candor_cost
open Candor_oracle

let published () =
  let is bytes expected =
    Alcotest.(check string) bytes expected (Base64.encode bytes)
  in
  is "" "";
  is "f" "Zg==";
  is "fo" "Zm8=";
  is "foo" "Zm9v";
  is "foob" "Zm9vYg==";
  is "fooba" "Zm9vYmE=";
  is "foobar" "Zm9vYmFy";
  is "\255\254\253" "//79"

let suite = ("base 64", [ Law.example "the examples of RFC 4648, 10" published ])

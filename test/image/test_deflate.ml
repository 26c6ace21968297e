open Candor_image_hidden
open Support
open QCheck2

let unpacked = Alcotest.(result string string)

let unpack ~bytes packed =
  Result.map Bytes.to_string (Deflate.unpack ~bytes packed)

let short = Error "the compressed data end early"
let long = Error "the compressed data hold more than the pixels declared"
let damaged = Error "the compressed data are damaged"

(* What packs well, what does not, and more than one buffer of either. *)
let data =
  let open Gen in
  let run = map2 String.make (int_range 0 3000) char in
  let noise = string_size (int_range 0 3000) in
  oneof
    [
      noise;
      run;
      map (String.concat "") (list_size (int_range 0 8) (oneof [ noise; run ]));
    ]

let print s = Printf.sprintf "%d bytes: %S" (String.length s) s

let there_and_back =
  law "what is packed is unpacked" ~print data (fun s ->
      unpack ~bytes:(String.length s) (Deflate.pack s) = Ok s)

(* RFC 1950: method 8, a header that 31 divides, Adler's sum at the end. *)
let framed =
  law "what is packed has zlib's header and checksum" ~print data (fun s ->
      let packed = Deflate.pack s in
      let last = String.length packed - 4 in
      Char.code packed.[0] land 15 = 8
      && String.get_uint16_be packed 0 mod 31 = 0
      && String.sub packed last 4 = Made_png.big4 (Made_png.adler32 s))

let foreign =
  law "what others packed is unpacked" ~print data (fun s ->
      unpack ~bytes:(String.length s) (Made_png.zlib s) = Ok s)

let other_length =
  law "no other length will do"
    ~print:Print.(pair print int)
    Gen.(pair data (int_range 1 2000))
    (fun (s, off) ->
      let bytes = String.length s and packed = Deflate.pack s in
      unpack ~bytes:(bytes + off) packed = short
      && (off > bytes || unpack ~bytes:(bytes - off) packed = long))

let checksum =
  law "a checksum with a wrong bit is an error"
    ~print:Print.(pair print int)
    Gen.(pair data (int_bound 31))
    (fun (s, bit) ->
      let packed = Bytes.of_string (Deflate.pack s) in
      let at = Bytes.length packed - 1 - (bit / 8) in
      Bytes.set_uint8 packed at
        (Bytes.get_uint8 packed at lxor (1 lsl (bit mod 8)));
      unpack ~bytes:(String.length s) (Bytes.to_string packed) = damaged)

let cut =
  law "packed data that were cut short are an error"
    ~print:Print.(pair print float)
    Gen.(pair data (float_bound_exclusive 1.))
    (fun (s, part) ->
      let packed = Deflate.pack s in
      let kept = int_of_float (part *. float_of_int (String.length packed)) in
      unpack ~bytes:(String.length s) (String.sub packed 0 kept) = short)

let nothing () =
  Alcotest.check unpacked "nothing" (Ok "") (unpack ~bytes:0 (Deflate.pack ""));
  Alcotest.check unpacked "no zlib" damaged (unpack ~bytes:3 "not zlib");
  Alcotest.check unpacked "no data" short (unpack ~bytes:3 "")

let allocated f =
  let before = Gc.allocated_bytes () in
  let result = f () in
  (result, Gc.allocated_bytes () -. before)

let frugal name expected ~bytes packed =
  let result, words = allocated (fun () -> unpack ~bytes packed) in
  Alcotest.check unpacked name expected result;
  if words > 100_000. then Alcotest.failf "%s: %.0f bytes were made" name words

let little_memory () =
  let small = Deflate.pack "small" in
  frugal "2^30 bytes in a few" short ~bytes:0x40000000 small;
  frugal "more bytes than there can be" short ~bytes:max_int small;
  frugal "five bytes of ten million" long ~bytes:5
    (Deflate.pack (String.make 10_000_000 'x'))

(* A run of one byte is packed 1:1032 at most, which must not count as short. *)
let dense () =
  let s = String.make 10_000_000 '\000' in
  Alcotest.(check bool)
    "unpacked" true
    (unpack ~bytes:(String.length s) (Deflate.pack s) = Ok s)

let suite =
  ( "deflate",
    [
      there_and_back;
      framed;
      foreign;
      other_length;
      checksum;
      cut;
      unit "there may be nothing to unpack" nothing;
      unit "data that cannot fit take no memory" little_memory;
      unit "the densest data are unpacked" dense;
    ] )

type t = { kind : string; data : string }

let signature = "\137PNG\r\n\026\n"
let crc file ~first ~length = Zlib.update_crc_string 0l file first length

let add out { kind; data } =
  let named = kind ^ data in
  Buffer.add_int32_be out (Int32.of_int (String.length data));
  Buffer.add_string out named;
  Buffer.add_int32_be out (crc named ~first:0 ~length:(String.length named))

let write chunks =
  let out = Buffer.create 4096 in
  Buffer.add_string out signature;
  List.iter (add out) chunks;
  Buffer.contents out

let unsigned file at =
  Int32.to_int (String.get_int32_be file at) land 0xffffffff

let ends_early = Error "the PNG file ends early"

let rec chunks file at read =
  let left = String.length file - at in
  if left < 12 then ends_early
  else
    let length = unsigned file at in
    let kind = String.sub file (at + 4) 4 in
    if left - 12 < length then ends_early
    else if
      not
        (Int32.equal
           (crc file ~first:(at + 4) ~length:(length + 4))
           (String.get_int32_be file (at + 8 + length)))
    then
      Error
        (Printf.sprintf "the checksum of chunk %S is wrong: the PNG is damaged"
           kind)
    else
      let read = { kind; data = String.sub file (at + 8) length } :: read in
      if kind = "IEND" then Ok (List.rev read)
      else chunks file (at + 12 + length) read

let read file =
  if String.starts_with ~prefix:signature file then
    chunks file (String.length signature) []
  else Error "this is not a PNG: its signature is missing or damaged"

let pack data =
  let out = Buffer.create (String.length data / 2) in
  let at = ref 0 in
  let refill chunk =
    let n = Int.min (Bytes.length chunk) (String.length data - !at) in
    Bytes.blit_string data !at chunk 0 n;
    at := !at + n;
    n
  in
  Zlib.compress refill (fun chunk n -> Buffer.add_subbytes out chunk 0 n);
  Buffer.contents out

let too_short = Error "the compressed data end early"
let too_long = Error "the compressed data hold more than the pixels declared"

let inflate stream ~bytes packed =
  let out = Bytes.create (bytes + 1) in
  let length = String.length packed in
  let rec go i o =
    let finished, used, made =
      Zlib.inflate_string stream packed i (length - i) out o
        (bytes + 1 - o)
        Zlib.Z_SYNC_FLUSH
    in
    let o = o + made in
    if o > bytes then too_long
    else if finished then
      if o = bytes then Ok (Bytes.sub out 0 bytes) else too_short
    else if used = 0 && made = 0 then too_short
    else go (i + used) o
  in
  go 0 0

(* Two bits, a length and a distance code, give at most 258 bytes. *)
let largest_ratio = 4 * 258

let unpack ~bytes packed =
  if bytes / largest_ratio > String.length packed then too_short
  else
    let stream = Zlib.inflate_init true in
    Fun.protect
      ~finally:(fun () -> Zlib.inflate_end stream)
      (fun () ->
        try inflate stream ~bytes packed
        with Zlib.Error _ -> Error "the compressed data are damaged")

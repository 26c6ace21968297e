(** PNG files made by hand, byte by byte from the standard: nothing here is
    shared with the library, nor with zlib. *)

let crc32 data =
  let step crc char =
    let rec shift crc n =
      if n = 0 then crc
      else
        let half = crc lsr 1 in
        shift (if crc land 1 = 1 then half lxor 0xedb88320 else half) (n - 1)
    in
    shift (crc lxor Char.code char) 8
  in
  String.fold_left step 0xffffffff data lxor 0xffffffff

let adler32 data =
  let step (a, b) char =
    let a = (a + Char.code char) mod 65521 in
    (a, (b + a) mod 65521)
  in
  let a, b = String.fold_left step (1, 0) data in
  (b lsl 16) lor a

let bytes_of n count shift =
  String.init count (fun i -> Char.chr ((n lsr shift i) land 255))

let big4 n = bytes_of n 4 (fun i -> 24 - (8 * i))
let little2 n = bytes_of n 2 (fun i -> 8 * i)

(** [zlib data] is [data] in one stored block; at most 65535 bytes. *)
let zlib data =
  let length = String.length data in
  String.concat ""
    [
      "\x78\x01\x01";
      little2 length;
      little2 (length lxor 0xffff);
      data;
      big4 (adler32 data);
    ]

let chunk kind data =
  big4 (String.length data) ^ kind ^ data ^ big4 (crc32 (kind ^ data))

let signature = "\137PNG\r\n\026\n"
let file chunks = String.concat "" (signature :: chunks)

let header ?(interlace = 0) ~width ~height ~depth ~colour () =
  let tail = [| depth; colour; 0; 0; interlace |] in
  chunk "IHDR"
    (big4 width ^ big4 height ^ String.init 5 (fun i -> Char.chr tail.(i)))

let channels = function 0 | 3 -> 1 | 4 -> 2 | 2 -> 3 | _ -> 4

(** [pack ~depth samples] is [samples] from the highest bit on, filled up with
    zeros to whole bytes. *)
let pack ~depth samples =
  let bits = Array.length samples * depth in
  let bit i =
    if i >= bits then 0
    else (samples.(i / depth) lsr (depth - 1 - (i mod depth))) land 1
  in
  let byte i = List.fold_left (fun n k -> (2 * n) + bit ((8 * i) + k)) 0 in
  String.init
    ((bits + 7) / 8)
    (fun i -> Char.chr (byte i [ 0; 1; 2; 3; 4; 5; 6; 7 ]))

let paeth a b c =
  let p = a + b - c in
  let nearest = min (abs (p - a)) (min (abs (p - b)) (abs (p - c))) in
  if abs (p - a) = nearest then a else if abs (p - b) = nearest then b else c

(** [filter kind ~stride ~above row] is [row] behind its filter byte [kind]. *)
let filter kind ~stride ~above row =
  let at s i = if i < 0 then 0 else Char.code s.[i] in
  let residue i =
    let a = at row (i - stride)
    and b = at above i
    and c = if i < stride then 0 else at above (i - stride) in
    let guess = [| 0; a; b; (a + b) / 2; paeth a b c |].(kind) in
    Char.chr ((Char.code row.[i] - guess) land 255)
  in
  String.make 1 (Char.chr kind) ^ String.init (String.length row) residue

(** [rows ~depth ~colour ~filters samples] is the image data of [samples], one
    array a row, each row with its own filter. *)
let rows ~depth ~colour ~filters samples =
  let stride = max 1 (depth * channels colour / 8) in
  let packed = Array.map (pack ~depth) samples in
  let row y row =
    let above =
      if y = 0 then String.make (String.length row) '\000' else packed.(y - 1)
    in
    filter filters.(y) ~stride ~above row
  in
  String.concat "" (Array.to_list (Array.mapi row packed))

let alphabet =
  "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/"

let encode bytes =
  let length = String.length bytes in
  let byte i = if i < length then Char.code bytes.[i] else 0 in
  let digit i =
    let group = i / 4 and place = i mod 4 in
    let at = 3 * group in
    if at + place > length then '='
    else
      let bits = (byte at lsl 16) lor (byte (at + 1) lsl 8) lor byte (at + 2) in
      alphabet.[(bits lsr (18 - (6 * place))) land 63]
  in
  String.init ((length + 2) / 3 * 4) digit

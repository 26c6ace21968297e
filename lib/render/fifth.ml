let count = 5
let all = List.init count Fun.id
let modulo n = ((n mod count) + count) mod count
let of_pixel x y = modulo (x + (2 * y))
let judges i = (modulo (i + 1), modulo (i + 2))

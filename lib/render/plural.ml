let count n noun = Printf.sprintf "%d %s%s" n noun (if n = 1 then "" else "s")

open Candor_number

type t = {
  a : float;
  b : float;
  scatter : float;
  points : int;
  centre : float;
  width : float;
}

let is_usable (x, y) =
  x > 0. && y > 0. && Float.is_finite x && Float.is_finite y

let sum f points = List.fold_left (fun s p -> s +. f p) 0. points

let line points =
  let n = float_of_int (List.length points) in
  let centre = sum fst points /. n and middle = sum snd points /. n in
  let width = sum (fun (x, _) -> (x -. centre) ** 2.) points in
  if not (width > 0.) then None
  else
    let slope =
      sum (fun (x, y) -> (x -. centre) *. (y -. middle)) points /. width
    in
    let residual (x, y) = y -. middle -. (slope *. (x -. centre)) in
    let squares = sum (fun p -> residual p ** 2.) points in
    let scatter = if n > 2. then sqrt (squares /. (n -. 2.)) else infinity in
    Some
      {
        a = exp (middle -. (slope *. centre));
        b = -.slope;
        scatter;
        points = List.length points;
        centre;
        width;
      }

let fit points =
  match List.filter is_usable points with
  | [] | [ _ ] -> None
  | usable -> line (List.map (fun (x, y) -> (log x, log y)) usable)

let at law x = law.a *. (x ** -.law.b)

type estimate = { best : float; low : float; high : float }

let inverse law y =
  if not (law.b > 0. && y > 0.) then None
  else
    let x = (log law.a -. log y) /. law.b in
    let n = float_of_int law.points in
    let range =
      if law.points = 2 then infinity
      else
        let leverage =
          1. +. (1. /. n) +. (((x -. law.centre) ** 2.) /. law.width)
        in
        Student.quantile ~dof:(n -. 2.) 0.975
        *. law.scatter *. sqrt leverage /. law.b
    in
    Some { best = exp x; low = exp (x -. range); high = exp (x +. range) }

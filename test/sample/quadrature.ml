(** Integrals by the rule of Gauss and Legendre. *)

let node = sqrt 0.6

(** [integral ~parts f a b] is the integral of [f] from [a] to [b], by three
    points in each of so many equal parts. *)
let integral ?(parts = 16) f a b =
  let h = (b -. a) /. float_of_int parts in
  let part i =
    let m = a +. ((float_of_int i +. 0.5) *. h) and d = 0.5 *. h *. node in
    ((5. *. f (m -. d)) +. (8. *. f m) +. (5. *. f (m +. d))) *. (h /. 18.)
  in
  List.fold_left (fun sum i -> sum +. part i) 0. (List.init parts Fun.id)

(** [over_rectangle f (a, b) (c, d)] is that of [f x y] for x in a..b, y in
    c..d, in 16 parts by 2. *)
let over_rectangle f (a, b) (c, d) =
  integral (fun x -> integral ~parts:2 (f x) c d) a b

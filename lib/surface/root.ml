open Candor_number

type t = First | Second

let falls ~b = function First -> not (b >= 0.) | Second -> b >= 0.

(* Whether a root t of a t^2 + 2 b t + c satisfies v + t w <= 0, exactly. With
   s = -v/w the question is how t compares with s, which the signs of the
   polynomial and of its slope at s answer. [falling] is the sign of the slope
   at the root. *)
let is_within (a, b, c) ~falling (v, w) =
  let open Expansion in
  match sign w with
  | 0 -> sign v <= 0
  | sw ->
      let w2 = mul w w in
      let two x = add x x in
      (* w^2 F(s) = a v^2 - 2 b v w + c w^2;  w^2 slope(s) = -a v w + b w^2 *)
      let value =
        sub (add (mul a (mul v v)) (mul c w2)) (two (mul b (mul v w)))
      in
      let slope = sub (mul b w2) (mul a (mul v w)) in
      let fs = sign value and gs = sign slope in
      let slope_at_root = if falling then -1 else 1 in
      (* The sign of s - t. *)
      let order =
        match sign a with
        | 0 -> fs * slope_at_root
        | sa ->
            if fs = 0 then if gs = slope_at_root || gs = 0 then 0 else gs * sa
            else if fs = sa then gs * sa (* s is outside of both roots *)
            else -slope_at_root * sa (* between them *)
      in
      (* v + t w <= 0 iff t <= s for w > 0, t >= s for w < 0. *)
      sw * order >= 0

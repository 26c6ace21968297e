(** Laws of derived equality, order and printing. *)

open Candor_oracle
open QCheck2

module type S = sig
  type t

  val show : t -> string
  val equal : t -> t -> bool
  val compare : t -> t -> int
end

let sign n = Int.compare n 0

(** [laws (module M) what gen] is that equality and order of [M.t] are such, and
    that equal values are printed alike. [gen] should make equal values often.
*)
let laws (type a) (module M : S with type t = a) what (gen : a Gen.t) =
  let law n name holds =
    let print l = String.concat "\n" (List.map M.show l) in
    Law.law ~count:1000 ~print (Printf.sprintf name what)
      (Gen.list_size (Gen.pure n) gen)
      holds
  in
  [
    law 1 "each of %s equals itself, in order too" (fun l ->
        List.for_all (fun a -> M.equal a a && M.compare a a = 0) l);
    law 2 "any two of %s are equal iff neither is before the other" (function
      | [ a; b ] ->
          M.equal a b = (M.compare a b = 0)
          && M.equal a b = M.equal b a
          && sign (M.compare a b) = -sign (M.compare b a)
      | _ -> false);
    law 3 "any three of %s can be put in order" (fun l ->
        match List.sort M.compare l with
        | [ a; b; c ] ->
            M.compare a b <= 0 && M.compare b c <= 0 && M.compare a c <= 0
        | _ -> false);
    law 2 "any two of %s that are equal are printed alike" (function
      | [ a; b ] -> (not (M.equal a b)) || String.equal (M.show a) (M.show b)
      | _ -> false);
  ]

(** [notices (module M) a changes] checks that each of [changes], values that
    differ from [a] and from each other in what they are named after, is told
    from all others by equality, by order and in print. *)
let notices (type a) (module M : S with type t = a) a changes =
  let all = ("unchanged", a) :: changes in
  List.iteri
    (fun i (name, x) ->
      List.iteri
        (fun j (name', y) ->
          let check what expected found =
            Alcotest.(check bool)
              (Printf.sprintf "%s, %s: %s" name name' what)
              expected found
          in
          check "equal" (i = j) (M.equal x y);
          check "in order" (i = j) (M.compare x y = 0);
          check "printed alike" (i = j) (String.equal (M.show x) (M.show y)))
        all)
    all

(** [often gen] makes the same value as often as another. *)
let often gen =
  let one = Gen.generate1 ~rand:(Random.State.make [| 5 |]) gen in
  Draw.either 50 (Gen.pure one) gen

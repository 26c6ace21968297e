(** Sums and products of doubles whose rounding error is known.

    [u] is 2^-53. None of these may overflow; products also need the exponent of
    their error to be above −1074. *)

type t = { hi : float; lo : float }
(** The exact value hi + lo, with |lo| ≤ ulp(hi)/2. *)

val two_sum : float -> float -> t
(** [two_sum a b] is [a + b] exactly. After D. Knuth,
    {e The Art of Computer Programming}, vol. 2, 4.2.2. *)

val two_diff : float -> float -> t
(** [two_diff a b] is [a - b] exactly. *)

val two_product : float -> float -> t
(** [two_product a b] is [a·b] exactly. *)

val difference_of_products : float -> float -> float -> float -> float
(** [difference_of_products a b c d] is a·b − c·d with relative error at most
    2u; so its sign is exact. After W. Kahan's algorithm as analysed by C.-P.
    Jeannerod, N. Louvet, J.-M. Muller,
    {e Further analysis of Kahan's algorithm for the accurate computation of 2×2
       determinants}, Math. Comp. 82, 2013. *)

val sum_error : float -> float -> float -> float
(** [sum_error a b s] is the error a + b − s of the sum [s = a +. b]. *)

val product_error : float -> float -> float -> float
(** [product_error a b p] is the error a·b − p of the product [p = a *. b]. *)

(** {1 Scalar products} *)

val dot : float -> float -> float -> float -> float -> float -> float
(** [dot a b c x y z] is (a·x + b·y) + c·z in plain doubles. *)

val dot_error :
  float -> float -> float -> float -> float -> float -> float -> float
(** [dot_error a b c x y z s] is what [s = dot a b c x y z] is off by, so that
    the two together are the scalar product as if computed in twice the
    precision: within 2^-104 of the sum of the absolute products. After T.
    Ogita, S. M. Rump, S. Oishi, {e Accurate Sum and Dot Product}, SIAM J. Sci.
    Comput. 26, 2005. *)

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

(** {1 Products of mild numbers}

    The same errors, bit by bit, without fused products: which are calls, for
    which all numbers at hand go to memory and back. After T. J. Dekker,
    {e A Floating-Point Technique for Extending the Available Precision}, Numer.
    Math. 18, 1971. *)

val is_mild : float -> bool
(** [is_mild x] is whether [x] is 0 or |x| is between 2^-480 and 2^480. *)

val head : float -> float
(** [head x] is [x] rounded to 26 bits, if it {!is_mild}. *)

val mild_product_error : float -> float -> float -> float -> float -> float
(** [mild_product_error a (head a) b (head b) (a *. b)] is
    [product_error a b (a *. b)] if [a] and [b] are mild. *)

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

val mild_dot_error :
  float ->
  float ->
  float ->
  float ->
  float ->
  float ->
  float ->
  float ->
  float ->
  float ->
  float ->
  float ->
  float ->
  float
(** [mild_dot_error a (head a) b (head b) c (head c) x (head x) y (head y) z
     (head z) s] is [dot_error a b c x y z s] if all six numbers are mild. *)

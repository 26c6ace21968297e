(** The incomplete gamma and beta functions, regularised: the distributions that
    sums of squares, Student's t and counts of successes follow.

    Each is a density times a series or a continued fraction, taken deep enough
    that going twice as deep changes no bit. Densities are written with
    deviances and Stirling's error as by C. Loader,
    {e Fast and Accurate Computation of Binomial Probabilities}, 2000, so that
    large parameters cost no accuracy; the fractions are Legendre's and that of
    A. R. DiDonato, A. H. Morris,
    {e Algorithm 708: Significant Digit Computation of the Incomplete Beta
       Function Ratios}, ACM TOMS 18(3), 1992.

    Parameters [a] and [b] lie in \[1/2, {!most}\]; for others, and for
    arguments that are negative or [nan], all is [nan]. The lesser tail has a
    relative error of at most 2^-48 + 2^-51·|ln tail| where the argument is
    exact, if it is not below 2^-1000; time grows as √(a + b) at most. *)

type t = { lower : float; upper : float; slope : float }
(** The two tails of a distribution at x, [lower] + [upper] = 1, and [slope],
    the derivative of [lower] by log x. *)

val most : float
(** [most] is 2^40, the greatest parameter. *)

val gamma : float -> float -> t
(** [gamma a x] has for [lower] P(a, x), the integral of s{^ a-1}·e{^ -s}/Γ(a)
    over s from 0 to [x]; [x] may be infinite. *)

val beta : float -> float -> odds:float -> t
(** [beta a b ~odds] has for [lower] I{_ x}(a, b), the integral of
    s{^ a-1}·(1−s){^ b-1}/B(a, b) over s from 0 to x, where [odds] is x/(1−x),
    which may be infinite. *)

val inverse : (float -> t) -> start:float -> float -> float
(** [inverse f ~start p] is where the lower tail of [f] is [p]: in \[0, ∞\],
    [nan] unless [p] is in \[0, 1\]. [f] must be log-concave in log x as are
    {!gamma} and {!beta}; [start] is near its middle. *)

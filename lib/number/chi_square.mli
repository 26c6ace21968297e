(** The chi-square distribution: that of the sum of the squares of [dof]
    independent normal variables, where [dof], the degrees of freedom, need not
    be whole.

    [dof] lies in \[1, 2^41\]; for others all is [nan]. Time grows as √dof. *)

val cdf : dof:float -> float -> float
(** [cdf ~dof x] is the probability of at most [x]; [nan] for x < 0. This and
    {!upper} are as accurate as {!Incomplete.gamma}. *)

val upper : dof:float -> float -> float
(** [upper ~dof x] is the probability of more than [x]. *)

val quantile : dof:float -> float -> float
(** [quantile ~dof p] is the x for which [cdf ~dof x] is [p], within a relative
    2^-48 + 2^-51·|ln p| where it is at least 2^-1020; it is positive for p > 0,
    ∞ at 1, [nan] outside \[0, 1\]. *)

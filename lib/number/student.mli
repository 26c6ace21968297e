(** Student's t distribution, of [dof] degrees of freedom, which need not be
    whole. *)

val quantile : dof:float -> float -> float
(** [quantile ~dof p] is the t that such a variable exceeds with probability 1 −
    p, within a relative 2^-45, for [dof] from 1 (Cauchy's distribution) to ∞
    (the normal one); -∞ at 0, ∞ at 1 and ±∞ where t is not a finite double;
    [nan] for lesser [dof] and outside \[0, 1\]. [quantile ~dof (1 − p)] is
    [−quantile ~dof p], to the bit if 1 − p is exact. *)

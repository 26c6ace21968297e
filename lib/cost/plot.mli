(** Error against seconds, both on logarithmic axes. *)

val v : width:float -> height:float -> Price.t -> Markup.t
(** [v ~width ~height p] is the plot of [p], drawn to be read when it is shown
    about [width] CSS pixels wide: the ladder and its Pareto front, the knee,
    other settings as letters ({!Wording.key}), the law that was fitted with the
    range that holds 95 % of its errors, and what errors of 4, 2, 1 and ½ are
    predicted to take. What lies outside the axes (errors of 0, say) stands as
    an arrow at their edge; what is not a number is left out. *)

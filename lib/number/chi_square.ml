let gamma ~dof x = Incomplete.gamma (dof /. 2.) (x /. 2.)
let cdf ~dof x = (gamma ~dof x).lower
let upper ~dof x = (gamma ~dof x).upper
let quantile ~dof p = Incomplete.inverse (gamma ~dof) ~start:dof p

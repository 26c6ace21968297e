(** Maps from the unit square to points and directions, each with the density of
    what it gives.

    The square is \[0;1\[²; uniform places in it make results of the stated
    density, and places that share the square out evenly make results that do.
    Directions are in a local frame whose third axis is the one of symmetry;
    {!to_world} turns them. Densities of directions are per steradian. *)

open Candor_space

(** {1 Frames} *)

val to_world : Frame.t -> Vec.t -> Dir.t
(** [to_world f d] is x·[f.u] + y·[f.v] + z·[f.w] for the local [d], with length
    1; [f.w] if that has no direction. *)

val to_local : Frame.t -> Dir.t -> Vec.t
(** [to_local f d] is [d] as seen in [f]: {!to_world} undone. *)

(** {1 Plane} *)

val disk : Pattern.position -> Vec.t
(** [disk p] is a point inside the unit disk around 0 in the plane z = 0, of
    density 1/π per area. After P. Shirley, K. Chiu,
    {e A Low Distortion Map Between Disk and Square}, Journal of Graphics Tools
    2(3), 1997. *)

(** {1 Directions} *)

val cosine_hemisphere : Pattern.position -> Dir.t
(** [cosine_hemisphere p] is a direction with z > 0, of density
    {!cosine_hemisphere_density}: the disk lifted to the sphere, T. Malley's
    method as in M. Pharr, W. Jakob, G. Humphreys,
    {e Physically Based Rendering}, 4th edition, 2023. *)

val cosine_hemisphere_density : float -> float
(** [cosine_hemisphere_density z] is z/π, and 0 for z < 0. *)

val sphere : Pattern.position -> Dir.t
(** [sphere p] is any direction, of density 1/4π: [cone ~one_minus_cos:2.]. *)

val cone : one_minus_cos:float -> Pattern.position -> Dir.t
(** [cone ~one_minus_cos p] is a direction at most θ from z, of density
    {!cone_density}; [one_minus_cos] is 1 − cos θ, in \]0;2\]. What is accurate
    to the last bits is its x and y, however narrow the cone is. The disk's
    points by J. H. Lambert's equal-area map,
    {e Anmerkungen und Zusätze zur Entwerfung der Land- und Himmelscharten},
    1772. *)

val cone_density : one_minus_cos:float -> float
(** [cone_density ~one_minus_cos] is 1 over the solid angle 2π(1 − cos θ). *)

val one_minus_cos : sin2:float -> float
(** [one_minus_cos ~sin2] is 1 − cos θ of the angle θ ≤ π/2 whose squared sine
    is [sin2], in \[0;1\]; accurate for the smallest. *)

val cone_of_ball : distance:float -> radius:float -> float
(** [cone_of_ball ~distance ~radius] is 1 − cos of the angle in which half of a
    ball of that radius is seen from that distance between its centre and the
    eye, which is the larger of the two. *)

(** {1 Scattering} *)

val henyey_greenstein : g:float -> Dir.t -> Dir.t -> float
(** [henyey_greenstein ~g w w'] is the density of light that travels along [w]
    being scattered to [w']: (1 − g²) / 4π(1 + g² − 2g·cos)^(3/2), with g, the
    mean cosine, in \]-1;1\[. It comes from [w' - w], so that it holds next to
    the peak of the sharpest. After L. G. Henyey, J. L. Greenstein,
    {e Diffuse radiation in the galaxy}, Astrophysical Journal 93, 1941. *)

val henyey_greenstein_sample : g:float -> Pattern.position -> Dir.t
(** [henyey_greenstein_sample ~g p] is a direction of density
    [henyey_greenstein ~g Dir.z]. Its cosine is the inverse of the distribution
    function, in a form without cancellation for any g. *)

(** {1 Numbers} *)

val exponential : rate:float -> float -> float
(** [exponential ~rate u] is a distance t ≥ 0 of density
    [exponential_density ~rate], for [rate > 0] per length: −log(1 − u)/rate. *)

val exponential_density : rate:float -> float -> float
(** [exponential_density ~rate t] is rate·exp(−rate·t). *)

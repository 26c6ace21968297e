(** Homogeneous media: what absorbs and scatters light on its way. *)

open Candor_space
open Candor_colour
open Candor_sample
open Candor_scene

type t = {
  extinction : Rgb.t;  (** the sum of absorption and scattering, per length *)
  scattering : Rgb.t;
  anisotropy : float;  (** Henyey and Greenstein's, in \]-1;1\[ *)
}

val of_fog : Scene.fog -> t

val of_material : Material.t -> t option
(** [of_material m] is what is inside a body of glass or of a translucent
    material that takes light away; [None] for any other. *)

val transmittance : t -> float -> Rgb.t
(** [transmittance m s] is the part of the light that goes straight through a
    length [s ≥ 0], by the law of Bouguer, Lambert and Beer: exp(−extinction·s);
    1 where nothing is taken away, however long the way is. *)

type event =
  | Scattered of { distance : float; weight : Rgb.t }
  | Passed of { weight : Rgb.t }

val sample : t -> carried:Rgb.t -> limit:float -> float -> event
(** [sample m ~carried ~limit u] is what becomes of light on a way of length
    [limit]: for [u] uniform in \[0;1\[ it is scattered at a distance, or
    passes. [weight] is what that counts for over its probability, which is the
    mean over the three colours' by how much a path has [carried] of each: so no
    colour outgrows the others on long ways. After M. J.-Y. Chiang, P. Kutz, B.
    Burley,
    {e Practical and Controllable Subsurface Scattering for Production Path
       Tracing}, 2016.

    Where nothing is absorbed, the sum of what is carried stays the same. *)

val sample_within :
  t -> carried:Rgb.t -> limit:float -> float -> (float * Rgb.t) option
(** [sample_within m ~carried ~limit u] is a distance up to [limit], which may
    be infinite, with scattering·transmittance over its density: the integral of
    what is scattered is the mean of what is found there, so weighted. [None]
    where nothing scatters. *)

(** {1 Scattering} *)

val phase : t -> Dir.t -> Dir.t -> float
(** [phase m along d] is how densely light that travels along [along] is
    scattered into [d], per steradian: {!Warp.henyey_greenstein}. *)

val deflect : t -> Dir.t -> Pattern.position -> Dir.t
(** [deflect m along p] is a direction of density [phase m along]. *)

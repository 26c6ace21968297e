(** Where a ray meets a surface. *)

open Candor_space

type 'm t = private {
  t : float;  (** in units of the ray's direction *)
  point : Point.t;
      (** as close to the surface as doubles allow; not simply the ray at [t] *)
  normal : Dir.t;
      (** the unit geometric normal on the side the ray came from *)
  shading_normal : Dir.t;
      (** the interpolated normal of a triangle that has one, on the same side;
          else [normal] *)
  side : Side.t;  (** the side that the ray came from *)
  path : int list;  (** the surface's place, from the top level down *)
  part : int;  (** which face or cap of it *)
  lift : Vec.t option;
      (** where a triangle with normals of its own stands for a surface that
          bulges beyond it on this side: the way there from [point] *)
  offset : float;
      (** ≥ 0; along [normal], the true surface is at most this far away *)
  local : Local.t;  (** the same point in the surface's own space *)
  material : 'm;  (** what the surface was made with *)
}

val v :
  t:float -> math:Math.t -> Contact.t -> Local.t -> Way.t -> int -> 'm -> 'm t
(** [v ~t ~math contact local way i m] is the hit at [local] of the surface at
    place [i] at the end of [way], carried back along that. The textbook's hits
    have no [offset]. *)

val spawn : 'm t -> Vec.t -> Ray.t
(** [spawn h d] is the ray that leaves [h] along [d]. It remembers the surface,
    which then cannot meet it again at the start; for all other surfaces its
    origin is moved off [h.point] to the side that [d] leaves on, by the proven
    error and no more. After M. Pharr, W. Jakob, G. Humphreys,
    {e Physically Based Rendering}, 4th ed. (2023), 6.8. *)

(** {1 Surfaces that touch}

    Points are rounded, so what is closer than that is in the same place. *)

type place = {
  onto : Ray.t;
      (** starts just in front of the hit and passes it without meeting it *)
  limit : float;  (** what [onto] meets up to this t is in the same place *)
  clearance : float;  (** how far from the hit that may be, in scene units *)
}

val place : 'm t -> Vec.t -> place
(** [place h d] is where [h] is, for a ray of direction [d] that met it there.
*)

val spawn_clear : 'm t -> place -> Vec.t -> Ray.t
(** [spawn_clear h p d] is [spawn h d], moved off all that is in the place [p]
    of [h]. *)

(** {1 Light that falls on a surface}

    A triangle with normals of its own turns from the light before or after the
    curved surface that it stands for does. Where that bulges, light is judged
    as it falls on that surface. *)

val faces : 'm t -> Vec.t -> bool
(** [faces h d] is [true] iff light from along [d] can fall on the side that the
    ray came from: [d] is on the side of [shading_normal] and, without a [lift],
    on that of [normal]. *)

val lit_point : 'm t -> Point.t
(** [lit_point h] is where light falls: [point], [lift]ed. *)

val spawn_lit : 'm t -> Vec.t -> Ray.t
(** [spawn_lit h d] is [spawn h d], but from {!lit_point}: for those [d] that
    [h] {!faces}. *)

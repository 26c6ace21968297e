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
  uv : (float * float) option Lazy.t;
  offset : float;
      (** ≥ 0; along [normal], the true surface is at most this far away *)
  local : Local.t;  (** the same point in the surface's own space *)
  material : 'm;  (** what the surface was made with *)
}

val v :
  t:float ->
  math:Math.t ->
  Contact.t ->
  Local.t ->
  groups:Transform.t list ->
  path:int list ->
  'm ->
  'm t
(** [v ~t ~math contact local ~groups ~path m] is the hit at [local], carried
    out through the transforms of the [groups] around it, innermost first. The
    textbook's hits have no [offset]. *)

val spawn : 'm t -> Vec.t -> Ray.t
(** [spawn h d] is the ray that leaves [h] along [d]. It remembers the surface,
    which then cannot meet it again at the start; for all other surfaces its
    origin is moved off [h.point] to the side that [d] leaves on, by the proven
    error and no more. After M. Pharr, W. Jakob, G. Humphreys,
    {e Physically Based Rendering}, 4th ed. (2023), 6.8. *)

(** Refraction: glass and the boundaries of translucent bodies reflect a part of
    the light and bend the rest. *)

open Candor_scene

val name : string
val meaning : string

val calls : Scene.t -> Reason.t list
(** [calls s] are the materials in use that let light through. *)

val is_body : Material.t -> bool
(** [is_body m] is [true] iff surfaces of [m] let light into what they enclose.
*)

val without : Material.t -> Material.t list -> Material.t list
(** [without m inside] is [inside] less the first that is [m]. *)

type index = Path.t -> Material.t -> float
(** The refractive index of a medium for the light of a path. *)

val index : index
(** [index] is the same for all light. *)

val touching :
  Tracer.t -> Tally.t -> Path.t -> Candor_surface.Hit.place -> Tracer.hit option
(** [touching tracer tally path place] is another surface in the place of a hit.
*)

val term : index -> splits:int -> Limit.t -> Tracer.t -> Term.t
(** [term index ~splits limit tracer] adds what smooth boundaries reflect and
    what they let through, by recursion, with the exact shares of both
    ({!Candor_optics.Refraction}): both where the path has taken fewer than
    [splits] steps, one by chance after that.

    Bodies may be nested, touch and overlap: where several overlap, the one that
    the path entered last counts, and leaving one that does not count bends
    nothing. Where two touch, one boundary leads from one to the other; where a
    body touches what is opaque, there is none. A ray that comes to a boundary
    from inside without having entered is inside. Radiance is not scaled by the
    square of the index: it is that which would be seen from empty space. *)

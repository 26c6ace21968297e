(** A piece of a quadric: the zero set of a polynomial of degree two, cut to
    size. *)

open Candor_number
open Candor_space

type t = private {
  form : Form.t;
  linear : bool;  (** whether [form] is *)
  cuts : Half_space.t array;
  disks : int array;  (** the cuts, by index, that a disk closes *)
}
(** The points of all [cuts] where [form] is 0; and on the plane of each cut in
    [disks] those of the other cuts where [form] is at most 0. *)

val make : Form.t -> cuts:Half_space.t array -> disks:int array -> t
(** [make form ~cuts ~disks] is that set. *)

val exact_equation :
  t -> Object_ray.t -> Expansion.t * Expansion.t * Expansion.t
(** [exact_equation q ray] is (a, b, c) with a·t² + 2b·t + c = F along [ray]. *)

(** {1 Cutting} *)

(** What t is a root of: F along the ray, rising or falling there, or the plane
    of one of the cuts. *)
type solved = Of_form of { falling : bool } | Of_cut of int

val within_cuts : t -> Object_ray.t -> float -> solved -> except:int -> bool
(** [within_cuts q ray t solved ~except] is whether the point at the root that
    [t] approximates is in all cuts but [except], decided for the exact root. *)

(** {1 Taking} *)

val consider :
  t -> Object_ray.t -> float -> float -> Root.t -> Cursor.t -> Contact.t
(** [consider q ray t b root cursor] takes the [root] of F at [t], where b has
    the sign given, if it is within [cursor] and the cuts. *)

val later : Contact.t -> Contact.t -> Contact.t
(** [later earlier last] is [last], unless that is no contact. *)

(** Triangles. *)

open Candor_space

type corners = { a : Point.t; b : Point.t; c : Point.t }
[@@deriving show, eq, ord]

type uv = {
  ua : float;
  va : float;
  ub : float;
  vb : float;
  uc : float;
  vc : float;
}
[@@deriving show, eq, ord]
(** Texture coordinates at the three corners. *)

type plane
(** The plane through three corners. *)

type t = private {
  corners : corners;
  plane : plane;
  normals : (Vec.t * Vec.t * Vec.t) option;
      (** what interpolated normals are made from, of any length *)
  uv : uv option;
}
[@@deriving show, eq, ord]
(** The closed triangle; outside is the side on which its corners run
    counter-clockwise. *)

val make :
  ?normals:Vec.t * Vec.t * Vec.t -> ?uv:uv -> corners -> (t, string) result
(** [make c] is the triangle with these corners; [Error why] if it has no area
    (decided exactly), a corner is beyond 2^400 or a normal is zero. *)

val bounds : t -> Bounds.t
(** [bounds s] is the least box that holds [s]. *)

val meet : t -> Object_ray.t -> Contact.t -> Cursor.t -> Contact.t
(** [meet s ray left cursor] is the contact of [ray] with [s] within [cursor],
    which moves there. A ray that [left] the triangle never meets it again; one
    in its plane never meets it.

    The signs of the three edges are exact, and ties are broken by moving [d] by
    an infinitesimal (ε, ε², ε³), the same way for every triangle: so a closed
    mesh is crossed consistently, without gap or double hit, even through its
    edges and corners. After H. Edelsbrunner, E. P. Mücke,
    {e Simulation of Simplicity}, ACM TOG 9(1), 1990. *)

val locate : t -> Object_ray.t -> Local.t
(** [locate s ray] is the point of [s] on the line of [ray], from its
    barycentric weights, so that its error does not grow with the distance. uv
    is interpolated from the triangle's own, else the weights of corners 2 and
    3. *)

(** What surfaces are made of. *)

open Candor_colour

type t =
  | Matte of { color : Texture.t }  (** the BRDF color/π *)
  | Phong of { color : Texture.t; specular : Rgb.t; shininess : float }
      (** matte plus specular·E⊥·max(0, n·h)^shininess, E⊥ the irradiance on a
          surface facing the light *)
  | Mirror of { color : Texture.t }  (** reflects color times what it sees *)
  | Glazed of { color : Texture.t; mirror : Rgb.t }
      (** matte plus [mirror] times what it reflects *)
[@@deriving show, eq, ord]

val default : t
(** [default] is matte grey .5, the material of a surface that names none. *)

(** What surfaces are made of. *)

open Candor_colour

(** What a surface does with light that falls on it. Indices are of refraction,
    relative to empty space; absorption and scattering are per unit length. *)
type kind =
  | Matte of { color : Texture.t }  (** the BRDF color/π *)
  | Phong of { color : Texture.t; specular : Rgb.t; shininess : float }
      (** matte plus specular·E⊥·max(0, n·h)^shininess, E⊥ the irradiance on a
          surface facing the light *)
  | Mirror of { color : Texture.t }  (** reflects color times what it sees *)
  | Glazed of { color : Texture.t; mirror : Rgb.t }
      (** matte plus [mirror] times what it reflects *)
  | Glass of {
      index : float;
      color : Texture.t;  (** multiplies each crossing and each reflection *)
      absorption : Rgb.t;  (** inside *)
      dispersion : float option;  (** the Abbe number *)
    }  (** a smooth dielectric *)
  | Metal of { reflectance : Texture.t; roughness : float }
  | Plastic of { color : Texture.t; index : float; roughness : float }
      (** a matte base of [color] under a coat *)
  | Translucent of {
      index : float;
      scattering : Rgb.t;
      absorption : Rgb.t;
      anisotropy : float;  (** Henyey and Greenstein's, in \]-1;1\[ *)
    }  (** a cloudy medium behind a smooth boundary *)
  | Emitter  (** sends light out and none back *)
[@@deriving show, eq, ord]

type t = {
  kind : kind;
  emission : Rgb.t;  (** radiance that leaves the surface by itself *)
}
[@@deriving show, eq, ord]

val v : kind -> t
(** [v kind] is a material that does not emit. *)

val emits : t -> bool
(** [emits m] is [true] iff its emission is not black. *)

val default : t
(** [default] is matte grey .5, the material of a surface that names none. *)

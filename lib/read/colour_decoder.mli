(** Colours and textures. *)

open Candor_colour
open Candor_scene
open Decode

val light : Rgb.t body
(** [light] is a colour of light: a grey number or [(rgb R G B)], not negative.
*)

val light_or : string -> (string * 'a body) list -> (Rgb.t -> 'a) -> 'a body
(** [light_or what cases f] is [f] of a colour of light, or one of [cases]; see
    {!Decode.choice}. *)

val reflectance : Rgb.t body
(** [reflectance] is a colour with components in \[0;1\]. *)

val texture : Texture.t body
(** [texture] is a {!reflectance} everywhere, or a texture of such. *)

val radiance : (string * Texels.t) body
(** [radiance] is the picture [FILE], whose name is kept as written; its path is
    relative to the text that names it. *)

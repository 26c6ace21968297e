(** What else stands in a scene once: picture, settings, light from all around.
*)

open Candor_scene
open Decode

val image : (int * int) body
(** [image] is width and height in pixels, 1 to 65536 each. *)

val render : Scene.settings body
(** [render] is how to render, with {!Scene.default_settings} for what is left
    out. *)

val background : Scene.background body
(** [background] is a colour of light, a gradient or a picture. *)

val indirect : Place.t body
(** [indirect] is nothing: that [(indirect-light)] is there says it all. *)

val fog : Scene.fog Scene.placed body
(** [fog] is a medium with [extinction], [albedo], and perhaps [anisotropy] and
    [within]. *)

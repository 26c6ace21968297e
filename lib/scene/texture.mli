(** Colours that may vary over a surface. *)

open Candor_colour

type t =
  | Constant of Rgb.t
  | Checker of { even : t; odd : t; scale : float }
      (** [even] where ⌊x/scale⌋ + ⌊y/scale⌋ + ⌊z/scale⌋ is even in the
          surface's own space, [odd] elsewhere; flat surfaces leave out the axis
          that their normal is largest in *)
  | Noise of { first : t; second : t; scale : float; octaves : int }
      (** a mix of both by gradient noise of position/scale, in the surface's
          own space *)
  | Image of { file : string; texels : Texels.t }
      (** by uv; [file] is the name as written *)
[@@deriving show, eq, ord]

val exists : (Rgb.t -> bool) -> t -> bool
(** [exists p t] is whether [p] holds for some colour that [t] is made of. *)

val greatest : t -> Rgb.t
(** [greatest t] has the greatest red, green and blue of all colours that [t] is
    made of: nowhere is it brighter. *)

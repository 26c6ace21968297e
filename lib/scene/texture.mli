(** Colours that may vary over a surface. *)

open Candor_colour

type t =
  | Constant of Rgb.t
  | Checker of { even : t; odd : t; scale : float }
      (** [even] where ⌊x/scale⌋ + ⌊y/scale⌋ + ⌊z/scale⌋ is even in the
          surface's own space, [odd] elsewhere; flat surfaces leave out the axis
          that their normal is largest in *)
[@@deriving show, eq, ord]

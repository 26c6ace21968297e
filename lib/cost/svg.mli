(** Drawings in the page. Coordinates are in units of the drawing, from its top
    left; those that are not finite are drawn at 0, and all are kept within a
    million, so a drawing is valid whatever is drawn. Colours come from the
    page's style, by class. *)

type point = float * float

val number : float -> string
(** [number x] is a coordinate as SVG writes it. *)

val drawing :
  width:float ->
  height:float ->
  kind:string ->
  says:string ->
  Markup.t list ->
  Markup.t
(** [drawing ~width ~height ~kind ~says parts] is as wide as its container.
    [says] tells what it shows to who does not see it; [kind] is its class. *)

val line : string -> point -> point -> Markup.t
(** [line kind a b] is a straight line of class [kind]. *)

val path : ?closed:bool -> string -> point list -> Markup.t
(** [path kind points] joins [points] by straight lines. *)

val circle : string -> point -> float -> Markup.t
(** [circle kind centre radius] *)

(** Where a text begins, is centred, or ends. *)
type anchor = Start | Middle | End

val text : string -> anchor -> point -> string -> Markup.t
(** [text kind anchor point s] stands on [point]. *)

val hint : string -> Markup.t list -> Markup.t
(** [hint s parts] is [parts], which say [s] when they are pointed at. *)

val window : point -> point -> Markup.t list -> Markup.t
(** [window (x, y) (width, height) parts] is [parts], whose origin is there, cut
    off at its edges. *)

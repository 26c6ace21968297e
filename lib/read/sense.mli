(** What makes sense by itself, but not together with the rest of a scene. *)

open Candor_scene

val check : Notes.t -> Scene.t -> unit
(** [check notes scene] notes an error, at its place, for

    - ambient light beside indirect light, which it stands in for;
    - materials in use that may return more light than they get, under indirect
      light: phong, and glazed where a part of color + mirror is above 1;
    - unbounded surfaces that emit, translucent surfaces that are not closed,
      and quadrics without uv under an image. Triangles and polygons in a group
      are trusted to close it together;
    - fog without bounds beside a directional light or a background that is not
      black: it would leave nothing of either;
    - surfaces that move farther than 2^400.

    Surfaces take their materials as in {!Assembly}: their own, else those of
    the nearest group or use around them. Definitions that nothing uses are not
    judged. Names that mean nothing, and cycles, are passed over. Takes time
    linear in the size of the scene (but for logarithms). *)

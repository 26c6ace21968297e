(** FLIP: how different two pictures look when one is flipped to the other on a
    display. After P. Andersson, J. Nilsson, T. Akenine-Möller, M. Oskarsson, K.
    Åström, M. D. Fairchild,
    {e FLIP: A Difference Evaluator for Alternating Images}, 2020, with all
    constants as published; filters are split into rows and columns as the
    authors' own program splits them.

    {b What is shown.} The numbers of PPM and PNG files drive an sRGB display,
    as the authors read theirs, whatever wrote them: a viewer does the same with
    files that Candor encoded by a power of 1/2.2. Linear radiance (PFM) is
    measured as Candor displays it: clamped to \[0;1\] and encoded by that power
    ({!Candor_colour.Display}) but not rounded, then shown on the same display;
    so a PFM file and a PNG of one render measure alike but for the rounding,
    and what is brighter than white is white. A [nan] is shown as black.

    {b Laws.} The map is 0 where what is shown is the same as far as {!reach}
    pixels around; it is the same bits for [v a b] and [v b a]. *)

type t
(** The difference in every pixel: 0 where nothing is seen, 1 for the greatest.
*)

val default_ppd : float
(** 67.02 pixels per degree: a display 0.7 m wide of 3840 pixels, seen from 0.7
    m. *)

val ppd_range : float * float
(** The least and the greatest number of pixels per degree, 1 and 1000. *)

val v :
  ppd:float ->
  Picture_file.content ->
  Picture_file.content ->
  (t, string) result
(** [v ~ppd a b] is the difference seen at [ppd] pixels per degree of visual
    angle. An error when the sizes differ. Raises [Invalid_argument] unless
    [ppd] is within {!ppd_range}. *)

val reach : ppd:float -> int
(** [reach ~ppd] is how many pixels around it a pixel's value depends on, each
    way. *)

val ppd : t -> float
(** The pixels per degree that it was made for. *)

val mean : t -> float
(** [mean f] is the mean over all pixels, in \[0;1\]. *)

val width : t -> int
val height : t -> int

val at : t -> int -> int -> float
(** [at f x y] is the difference in column [x], row [y], in \[0;1\]. Raises
    [Invalid_argument] outside the picture. *)

val heatmap : Picture_file.format -> t -> Picture.t
(** [heatmap format f] is [f] as a picture to write in that format: in the
    colours of {!Magma} for PPM and PNG, and for PFM the values themselves, in
    all three channels. *)

val to_text : t -> string
(** [to_text f] is the mean for people, as one ended line below those of
    {!Comparison.to_text}. *)

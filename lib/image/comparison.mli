(** How far one picture is from another.

    Whole-number files are compared in units of 1/255 of full brightness,
    whatever their depth; linear ones in their own unit. With [d = a − b] over
    all channels of all pixels, [b] the reference:
    - root mean square, √(mean d²);
    - mean absolute, mean |d|;
    - maximum, max |d|;
    - relative mean square, mean (d² / (b² + 0.001)), with both values taken as
      parts of full brightness for whole-number files. After F. Rousselle, C.
      Knaus, M. Zwicker,
      {e Adaptive Sampling and Reconstruction using Greedy Error Minimization},
      2011; the constant keeps black pixels from ruling.

    Values that are the same infinity, or [nan] in both, differ by 0. A value
    that is infinite on one side only makes all four measures infinite; a [nan]
    on one side only makes them [nan]. Sums are plain doubles, row by row, of
    terms that are never negative: off by less than 2^-39 of their value up to
    4096 x 4096 pixels. *)

type measure = Levels  (** units of 1/255. *) | Radiance  (** linear. *)
[@@deriving show, eq]

type t = {
  width : int;
  height : int;
  measure : measure;
  rmse : float;
  mae : float;
  max : float;
  rel_mse : float;
  non_finite : int;
      (** pixels with an infinite or [nan] channel in either picture. *)
}
[@@deriving show, eq]

val v : Picture_file.content -> Picture_file.content -> (t, string) result
(** [v a b] compares [a] with the reference [b]. An error when their sizes
    differ, or one is linear and the other is not. *)

val within : float -> t -> bool
(** [within e c] is [true] iff [c.rmse <= e]; so never when it is [nan]. *)

val to_text : t -> string
(** [to_text c] is [c] for people, one measure a line, each line ended. *)

val to_json : ?also:(string * float) list -> t -> string
(** [to_json ~also c] is [c] as one line of JSON with the keys [width],
    [height], [unit] (["1/255"] or ["linear"]), [rmse], [mae], [max], [rel_mse],
    [non_finite] and then those of [also] (default none), plain names of other
    measures, without an end of line. Measures that are not finite are [null];
    finite ones read back as the same doubles. *)

(** Labels that keep out of each other's way. *)

type box = { left : float; top : float; width : float; height : float }
(** A rectangle of a drawing. *)

val around : Svg.point -> float -> box
(** [around p r] is the square of half side [r] about [p]. *)

type t = { at : Svg.point; anchor : Svg.anchor; says : string; kind : string }
(** A label where it is drawn: the text's base line begins, is centred or ends
    [at]. *)

type wish = {
  mark : Svg.point;
  clear : float;  (** from the middle of the mark to its edge *)
  text : string;
  style : string;
}
(** A label that wants to stand near its mark. *)

val place : size:float -> within:box -> taken:box list -> wish list -> t list
(** [place ~size ~within ~taken wishes] are those of [wishes] for which there is
    room beside their mark, first come, first served: inside [within], and off
    [taken] and the labels before. Texts are [size] high; their width is
    guessed. *)

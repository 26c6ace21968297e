(** Where places lie in a text: the spans that a scene does not keep. *)

open Candor_scene

val spans : Source.t -> Place.t list -> Place.t -> Span.t option
(** [spans s places] tells where each of [places] is in the text [s], in one
    reading of it; [None] where the text has changed so that it has no such
    line. As with {!Located}, a form is underlined at its head. *)

(** What readers of a scene write down besides the scene: errors, and the names
    that must turn out to mean something.

    Local mutation: notes grow while a scene is read, and are looked at once, at
    the end. *)

open Candor_scene

type t

val make : unit -> t
(** [make ()] is empty, and about no text yet. *)

val within : t -> Source.t -> t
(** [within n s] writes into [n] what concerns the text [s]. *)

val place : t -> Span.t -> Place.t
(** [place n span] is where [span] is in the text that [n] is about. *)

val beside : t -> string -> string
(** [beside n path] is [path] as seen from the folder of that text. *)

val error : t -> Span.t -> ?hint:string -> string -> unit
(** [error n span message] notes that [message] applies to [span]. *)

val refuse : t -> Span.t -> ?hint:string -> string -> 'a option
(** [refuse n span message] is [None], with that {!error}. *)

val error_at : t -> Place.t -> ?hint:string -> string -> unit
(** [error_at n place message] notes that [message] applies to the form at
    [place], in whichever text that is. *)

val fault : t -> Fault.t -> unit
(** [fault n f] notes that the text was not read to its end, forgets what is
    noted of the part that [f] distrusts, and leaves [n] {!incomplete}. *)

val give_up : t -> unit
(** [give_up n] leaves [n] {!incomplete}. *)

val incomplete : t -> bool
(** [incomplete n] is [true] iff parts of the scene are unread, so that what
    seems to be missing from it may be there. *)

val is_clean : t -> bool
(** [is_clean n] is [true] iff no error is noted. *)

type kind = Material | Definition

val mention : t -> kind -> string -> Span.t -> string
(** [mention n kind name span] is [name] (one copy for all mentions), and notes
    that it must be the name of something. *)

val check_mentions :
  t -> kind -> is_known:(string -> bool) -> known:string list -> unit
(** [check_mentions n kind ~is_known ~known] notes an error for each name that
    was mentioned but is not known, at its first mention. [known] is for hints.
*)

val picture :
  t ->
  string ->
  (unit -> (Texels.t, string) result) ->
  (Texels.t, string) result
(** [picture n key load] is [load ()], the same for all that ask with this
    [key]: a file is read once however often a scene names it. *)

val mesh :
  t -> string -> (unit -> (Faces.t, string) result) -> (Faces.t, string) result
(** [mesh n key load] is [load ()] likewise. *)

val report : t -> Error.report
(** [report n] is all errors by place, files in the order of their reading, the
    same error in a file that was read twice only once. Beyond the first
    thousand noted, errors are only counted. *)

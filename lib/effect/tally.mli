(** Counts of what was done. Terms write to a tally and never read it, so that
    counting cannot change a picture. Each row of pixels has its own; they are
    added up in row order. *)

open Candor_colour

type counter =
  | Camera_rays
  | Shadow_rays
  | Mirror_rays
  | Refraction_rays  (** what glass reflects and lets through *)
  | Bounce_rays  (** indirect light *)
  | Emitter_rays  (** towards area lights, and in search of them *)
  | Sky_rays  (** towards the bright parts of a sky *)
  | Scattered_rays  (** after scattering in a medium *)
  | Cut_by_depth  (** steps left out: the path was at its depth *)
  | Cut_by_weight  (** steps left out: the throughput was too small *)
  | Non_finite  (** samples whose radiance was infinite or not a number *)
  | Spared_samples
      (** samples that were not taken: another had decided the pixel *)
[@@deriving show, eq, ord]

val counters : counter list
(** [counters] is every counter once. *)

val rays : counter list
(** [rays] are those that count rays, with names by {!name}. *)

val name : counter -> string
(** [name c] is what statistics call [c]. *)

type t

val make : ?watch:(Event.t -> unit) -> unit -> t
(** [make ()] counts from zero. [watch] is shown every event. *)

val count : t -> counter -> unit
(** [count t c] adds one. *)

val get : t -> counter -> int
(** [get t c] is how often [c] was counted. *)

val leave_out : t -> carried:Rgb.t -> Rgb.t -> unit
(** [leave_out t ~carried weight] adds [carried] times [weight] to what
    {!left_out} tells: the throughput of a step that was not taken. It allocates
    nothing. *)

val left_out : t -> Rgb.t
(** [left_out t] is the throughput of all that was left out since [t] was made
    or {!start_anew}: times the greatest radiance that it could have found, it
    bounds the light that was lost. *)

val start_anew : t -> unit
(** [start_anew t] makes [left_out t] black, as at the beginning of a pixel. *)

val move_left_out : t -> floatarray -> int -> unit
(** [move_left_out t a i] adds red, green and blue of [left_out t] to [a] from
    index [i] on, and starts anew. It allocates nothing. Raises
    [Invalid_argument] if [a] is too short. *)

val total_rays : t -> int
(** [total_rays t] is how many rays were counted, of all kinds. *)

val effort : t -> Candor_surface.Effort.t
(** [effort t] is what intersection queries add to. *)

val sum : t list -> t
(** [sum ts] has the counts of all [ts] together, and what they left out. *)

val watched : t -> bool
(** [watched t] is [true] iff somebody looks at events. *)

val show : t -> Event.t -> unit
(** [show t e] shows [e] to the watcher, if there is one. Ask {!watched} before
    making an event. *)

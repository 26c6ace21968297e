(** How much of a render is done, and how sure that is. *)

type t = { share : float; low : float; high : float }
(** The [share] of all work that is done, in \[0, 1\]: it is within \[[low],
    [high]\] with a confidence of about 95 %. *)

val sure : float -> t
(** [sure share] is without doubt. *)

val of_parts : count:int -> seconds:float list -> t
(** [of_parts ~count ~seconds] is when some of [count] ≥ 1 parts, a fair sample
    of them, took these [seconds] each: the others will take as long on average,
    give or take what those differ by. *)

val of_forecast : taken:float -> Forecast.t -> t
(** [of_forecast ~taken f] is when [taken] of the samples that [f] expects are
    there. *)

val time_left : t -> elapsed:float -> float * float * float
(** [time_left p ~elapsed] is how many seconds are left after [elapsed], and
    from where to where it may be; infinite if nothing is known. *)

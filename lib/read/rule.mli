(** What a number must be. *)

type t
(** A condition on finite numbers, with words for it. *)

val any : t
(** [any] holds for every number. *)

val length : t
(** [length] holds for coordinates and offsets: at most 2^400 in size. *)

val size : t
(** [size] holds for radii and scales: above 0, and in \[2^-400;2^400\]. *)

val distance : t
(** [distance] holds for lengths that may be zero: in \[0;2^400\]. *)

val above_zero : t
(** [above_zero] holds for x > 0. *)

val not_negative : t
(** [not_negative] holds for x ≥ 0, and so for both zeros. *)

val within : float -> float -> t
(** [within a b] holds in \[[a];[b]\]. *)

val between : float -> float -> t
(** [between a b] holds in \]a;b\[. *)

val broken : t -> float -> string option
(** [broken r x] is what [x] must be to keep to [r], such as
    ["must be above 0"]; [None] if it does. *)

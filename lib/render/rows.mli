(** The one module that knows about domains. *)

val parallel :
  domains:int -> stop:(unit -> bool) -> int -> (int -> 'a) -> 'a option array
(** [parallel ~domains ~stop n f] is [Array.init n (fun i -> Some (f i))],
    computed by [domains ≥ 1] domains that take rows as they get free, in an
    order that is fair to all parts of the picture. Rows not begun when
    [stop ()] first answers [true] are [None]. If [f] is pure the result does
    not depend on [domains]. *)

val most_domains : unit -> int
(** [most_domains ()] is how many domains this machine runs well. *)

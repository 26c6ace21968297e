(** Did you mean. *)

val distance : most:int -> string -> string -> int
(** [distance ~most a b] is the least number of letters to insert, delete,
    replace or swap with their neighbour, no letter touched twice, that turns
    [a] into [b]; [most + 1] if it is above [most].

    After F. Damerau,
    {e A technique for computer detection and correction of spelling errors},
    CACM 7(3), 1964, doi:10.1145/363958.363994; in the form called optimal
    string alignment. *)

val nearest : string -> among:string list -> string option
(** [nearest word ~among] is the word that [word] was probably meant to be: the
    first of those at the least {!distance}, which must be at most 2 and at most
    half of [word]'s length. [None] for words above 60 letters; of a very long
    list only the first thousand are considered. *)

val hint : string -> among:string list -> string option
(** [hint word ~among] asks whether {!nearest} was meant. *)

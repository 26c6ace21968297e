(** Choices between seconds and errors. *)

type point = { seconds : float; error : float }

val pareto : point list -> bool list
(** [pareto points] says of each point whether nothing beats it: no other is
    better one way without being worse the other way. Of equal points all stay.
    A coordinate that is [nan] counts as ∞. *)

val knee : point list -> int option
(** [knee points] is the index of the point after which more seconds bring
    disappointingly little: with seconds and errors each stretched to \[0;1\],
    the one that lies furthest below the chord from the first to the last. After
    V. Satopaa, J. Albrecht, D. Irwin, B. Raghavan,
    {e Finding a "Kneedle" in a Haystack: Detecting Knee Points in System
       Behavior}, 2011, without smoothing. [points] are by growing seconds;
    [None] if none lies below the chord. *)

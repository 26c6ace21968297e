(** The price list as text. *)

open Candor_scene

val setting : Price.setting -> string
(** [setting s] is what [s] is called: [spp 16], [depth 3],
    [without point light], [naive math], … *)

val place : Price.setting -> string option
(** [place s] is where the scene asks for what [s] leaves out, as
    [file:line:column], of several the first; [None] where no file does. *)

val table : Scene.t -> Price.t -> string
(** [table scene p] is the list for people: a line for each rung of the ladder,
    and then for each other setting, as differences from the rung with as many
    samples. [*] marks the lines that no other beats. Below stand what is paid
    for nothing, with its places, the law, and the predictions. Every line ends
    with a newline. *)

val csv : Price.t -> string
(** [csv p] has the columns setting, spp, seconds, rays_per_pixel, rms, p99 and
    pareto ([true] or [false]), named in the first line, as RFC 4180 has it but
    with plain newlines. *)

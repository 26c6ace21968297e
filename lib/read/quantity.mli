(** Bodies made of numbers. *)

open Decode

val number : ?hint:string -> Rule.t -> (unit -> string) -> float value
(** [number ~hint rule called] is a number that keeps to [rule]; errors call it
    [called ()]. [hint] is for what is no number. *)

val numbers : string -> Rule.t -> float array body
(** [numbers "X Y Z" rule] is three numbers so called, each kept to [rule]. *)

val scalar : string -> Rule.t -> float body
(** [scalar "R" rule] is one number. *)

val wholes : string -> min:int -> max:int -> int array body
(** [wholes "W H" ~min ~max] is two whole numbers in \[[min];[max]\]. *)

val whole : string -> min:int -> max:int -> int body
(** [whole "N" ~min ~max] is one of them. *)

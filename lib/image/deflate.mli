(** Whole strings through zlib (RFC 1950). *)

val pack : string -> string
(** [pack data] is [data] compressed, with zlib's header and checksum. *)

val unpack : bytes:int -> string -> (Bytes.t, string) result
(** [unpack ~bytes packed] is the data that were packed, an error unless they
    are exactly [bytes] long and their checksum is right. Never more than
    [bytes + 1] bytes are unpacked, and none are allocated for a [packed] that
    is too short to hold [bytes]. *)

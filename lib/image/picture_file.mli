(** Picture files of all formats: which one a file is in, and what it holds. *)

(** The formats that Candor writes and reads. *)
type format = Ppm | Png | Pfm [@@deriving show, eq]

(** What a file holds. *)
type content =
  | Display of Raster.t  (** whole numbers ready for a display: PPM and PNG. *)
  | Linear of Picture.t  (** linear radiance: PFM. *)

val format_of_name : string -> (format, string) result
(** [format_of_name name] is the format that the extension of [name] stands for:
    [.ppm], [.png] or [.pfm], in either case. *)

val encode : format -> binary:bool -> Picture.t -> string
(** [encode format ~binary p] is the file that holds [p]. [binary] chooses P6
    over P3 for a PPM; the other formats are binary in any case. *)

val decode : string -> (content, string) result
(** [decode file] is what [file] holds. Its format is told from its first bytes,
    not from a name. *)

(* How long a kernel takes, beside the textbook's. *)

open Candor_space
open Candor_surface
open Candor_oracle

type asked = {
  meets : int -> bool;
  careful : int -> bool;  (** whether plain doubles did not do *)
}
(** What a kernel says of the case of this number. *)

type 'shape kernel = 'shape Family.case array -> asked
type 'shape kernels = { ours : 'shape kernel; textbook : 'shape kernel option }

(** [alone meet] is the kernel of one surface. *)
let alone meet cases =
  let shapes = Array.map (fun c -> c.Family.shape) cases
  and rays =
    Array.map
      (fun { Family.ray = { Ray.origin; direction; _ }; _ } ->
        Object_ray.v origin direction)
      cases
  in
  let meets i =
    let contact : Contact.t = meet shapes.(i) rays.(i) (Cursor.v infinity) in
    not (Contact.is_none contact)
  and careful i =
    let cursor = Cursor.v infinity in
    ignore (meet shapes.(i) rays.(i) cursor : Contact.t);
    cursor.careful > 0.
  in
  { meets; careful }

(** [plainly meet] is the same for a kernel of the textbook. *)
let plainly meet =
  alone (fun s (r : Object_ray.t) cursor -> meet s r.origin r.direction cursor)

(** [query surface] asks for the nearest hit. *)
let query surface cases =
  let surfaces = Array.map (fun c -> surface c.Family.shape) cases
  and rays = Array.map (fun c -> c.Family.ray) cases in
  let meets i = Option.is_some (Surface.nearest surfaces.(i) rays.(i))
  and careful i =
    let effort = Effort.make () in
    ignore (Surface.nearest surfaces.(i) ~effort rays.(i) : _ Hit.t option);
    Effort.careful effort > 0
  in
  { meets; careful }

let batch = 2000
let repeats = 10
let tries = 7

(* Nanoseconds per call, the least of several tries. *)
let nanoseconds kernel cases =
  let { meets; _ } = kernel cases and n = Array.length cases in
  let attempt () =
    let start = Sys.time () in
    for _ = 1 to repeats do
      for i = 0 to n - 1 do
        ignore (Sys.opaque_identity (meets i) : bool)
      done
    done;
    (Sys.time () -. start) *. 1e9 /. float_of_int (repeats * n)
  in
  let rec best k least =
    if k = 0 then least else best (k - 1) (Float.min least (attempt ()))
  in
  best tries (attempt ())

(* Too few cases say nothing. *)
let column kernels cases =
  if Array.length cases < batch / 40 then Printf.sprintf "%19s" "-"
  else
    let ours = nanoseconds kernels.ours cases in
    match kernels.textbook with
    | None -> Printf.sprintf "%6.0f %12s" ours "-"
    | Some kernel ->
        let theirs = nanoseconds kernel cases in
        Printf.sprintf "%6.0f %6.0f %5.2f" ours theirs (ours /. theirs)

let share tally n =
  let count = ref 0 in
  for i = 0 to n - 1 do
    if tally i then incr count
  done;
  100. *. float_of_int !count /. float_of_int n

let heading =
  Printf.sprintf "%6s %6s %6s %5s %6s %6s %5s" "care %" "miss" "book" "ratio"
    "hit" "book" "ratio"

(** [row kernels family] is the share of cases in which plain doubles did not
    do, and the time of misses and hits. *)
let row kernels family =
  let cases = Family.sample family batch in
  let asked = kernels.ours cases in
  let some keep =
    List.init batch Fun.id |> List.filter keep
    |> List.map (Array.get cases)
    |> Array.of_list
  in
  Printf.sprintf "%6.2f %s %s"
    (share asked.careful batch)
    (column kernels (some (fun i -> not (asked.meets i))))
    (column kernels (some asked.meets))

type style = Silent | Bar | Lines

type t = {
  style : style;
  clock : Clock.t;
  last : float Atomic.t; (* when something was last said, in seconds *)
}

let make ~quiet =
  let style =
    if quiet then Silent else if Unix.isatty Unix.stderr then Bar else Lines
  in
  { style; clock = Clock.start (); last = Atomic.make 0. }

let elapsed p = Clock.seconds p.clock

let time s =
  if s < 9.95 then Printf.sprintf "%.1f s" s
  else if s < 59.5 then Printf.sprintf "%.0f s" s
  else
    let s = int_of_float (Float.round s) in
    if s < 3600 then Printf.sprintf "%d min %d s" (s / 60) (s mod 60)
    else Printf.sprintf "%d h %d min" (s / 3600) (s / 60 mod 60)

let width = 30

let bar share =
  let full = int_of_float (share *. float_of_int width) in
  String.make full '#' ^ String.make (width - full) '.'

(* A picture does not fail because nobody listens. *)
let talk format =
  let speak text = try Printf.eprintf "%s%!" text with Sys_error _ -> () in
  Printf.ksprintf speak format

(* With its range, where that is known. *)
let left pace ~elapsed =
  let left, low, high = Pace.time_left pace ~elapsed in
  if left = infinity then ""
  else if high = infinity || time low = time high then time left ^ " left"
  else Printf.sprintf "%s left (%s to %s)" (time left) (time low) (time high)

let say p elapsed (pace : Pace.t) =
  let left = left pace ~elapsed and percent = 100. *. pace.share in
  match p.style with
  | Silent -> ()
  | Bar -> talk "\r[%s] %3.0f %%  %s\027[K" (bar pace.share) percent left
  | Lines -> talk "%3.0f %% done, %s\n" percent left

let pause = function Silent -> infinity | Bar -> 0.1 | Lines -> 5.

let report p pace =
  let now = elapsed p and last = Atomic.get p.last in
  (* Whoever moves [last] speaks; the others go on with their rows. *)
  if now -. last >= pause p.style && Atomic.compare_and_set p.last last now then
    say p now pace

let finish p =
  match p.style with Bar -> talk "\r\027[K" | Silent | Lines -> ()

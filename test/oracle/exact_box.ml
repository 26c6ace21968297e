(** Boxes in exact arithmetic: closed slabs. *)

open Candor_space
open Crossing

(* When and through which part the line enters and leaves a slab. *)
type gate = { at : Exact_root.t; part : int; off : Wide.t Lazy.t }

type passage =
  | Always of { margin : Dyadic.t }
      (** how far within the slab; never if that is below zero *)
  | From of { entry : gate; exit : gate }

(* How far t may be off for a blurred line. *)
let off (line : Line.t) at speed =
  lazy
    (let open Wide in
     let t = abs (Exact_root.estimate at) in
     let drift = mul t (of_dyadic line.blur.of_direction) in
     div (add (of_dyadic line.blur.of_origin) drift) (abs (of_dyadic speed)))

let slab (line : Line.t) axis lo hi o d =
  let open Dyadic in
  let lo = of_float lo * line.weight and hi = of_float hi * line.weight in
  let low = Int.mul 2 axis in
  let gate face part =
    let at = Exact_root.ratio (face - o) d in
    { at; part; off = off line at d }
  in
  match sign d with
  | 0 -> Always { margin = min (o - lo) (hi - o) }
  | s ->
      let low = gate lo low and high = gate hi (succ low) in
      if s > 0 then From { entry = low; exit = high }
      else From { entry = high; exit = low }

(* The gates met so close to [g] that doubles cannot tell them apart. *)
let together g gates =
  let close g' =
    g' == g
    ||
    match (g.at, g'.at) with
    | Ratio a, Ratio b ->
        let open Dyadic in
        let x = a.over * b.under and y = b.over * a.under in
        leq (abs (x - y)) (shift (-51) (abs x))
    | _ -> false
  in
  List.filter close gates

let latest gates =
  let later a b = if Exact_root.before a.at b.at then b else a in
  match gates with
  | [] -> None
  | g :: rest -> Some (List.fold_left later g rest)

let earliest gates =
  let earlier a b = if Exact_root.before a.at b.at then a else b in
  match gates with
  | [] -> None
  | g :: rest -> Some (List.fold_left earlier g rest)

(* Whether an entry and an exit are too close in time for a blurred line, or it
   runs too close along a face. *)
let band (line : Line.t) entries exits margins =
  let gap a b =
    match (a.at, b.at) with
    | Exact_root.Ratio x, Exact_root.Ratio y ->
        let open Wide in
        div
          (of_dyadic Dyadic.((x.over * y.under) - (y.over * x.under)))
          (mul (of_dyadic x.under) (of_dyadic y.under))
    | _ -> Wide.zero
  in
  let close a b =
    a.part / 2 <> b.part / 2
    && Wide.(leq (abs (gap a b)) (add (Lazy.force a.off) (Lazy.force b.off)))
  in
  let last =
    List.fold_left
      (fun t g -> Wide.(max t (abs (Exact_root.estimate g.at))))
      Wide.zero (entries @ exits)
  in
  let off =
    Wide.(
      add
        (of_dyadic line.blur.of_origin)
        (mul last (of_dyadic line.blur.of_direction)))
  in
  List.exists (fun a -> List.exists (close a) exits) entries
  || List.exists (fun m -> Wide.(leq (abs (of_dyadic m)) off)) margins

let truth_along (b : Candor_surface.Box.t) (line : Line.t) =
  let b = (b :> Bounds.t) and o = line.origin and d = line.direction in
  let slabs =
    [
      slab line 0 b.x0 b.x1 o.x d.x;
      slab line 1 b.y0 b.y1 o.y d.y;
      slab line 2 b.z0 b.z1 o.z d.z;
    ]
  in
  let gates pick =
    List.filter_map
      (function
        | Always _ -> None | From { entry; exit } -> Some (pick entry exit))
      slabs
  in
  let entries = gates (fun entry _ -> entry)
  and exits = gates (fun _ exit -> exit) in
  let margins =
    List.filter_map
      (function Always { margin } -> Some margin | From _ -> None)
      slabs
  in
  let never = List.exists (fun m -> Dyadic.sign m < 0) margins in
  let band =
    if Line.is_sharp line then lazy false
    else lazy (band line entries exits margins)
  in
  match (latest entries, earliest exits) with
  | Some near, Some far when (not never) && Exact_root.before near.at far.at ->
      let at side gate g = { at = gate.at; side; part = g.part } in
      let slack =
        if Line.is_sharp line then Dyadic.zero
        else
          Crossing.slack (Wide.max (Lazy.force near.off) (Lazy.force far.off))
      in
      {
        crossings =
          List.map (at Side.Outside near) (together near entries)
          @ List.map (at Side.Inside far) (together far exits);
        band;
        slack;
      }
  | _ -> { (exactly []) with band }

(** [truth b line] is where [line] crosses the faces of [b]. *)
let truth b line = truth_along b (Crossing.exact line)

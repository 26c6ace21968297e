(** Families of cases, each planting one kind of difficulty, and what the
    library makes of them beside the exact truth. *)

open QCheck2

type 'shape case = { shape : 'shape; ray : Candor_space.Ray.t }
type 'shape t = { name : string; cases : 'shape case Gen.t }

type 'shape kind = {
  show : 'shape -> string;
  answer : 'shape -> Candor_space.Ray.t -> Crossing.answer option;
  truth : 'shape -> Line.t -> Crossing.truth;
}
(** How to judge a kind of surface. *)

let show kind { shape; ray } =
  Printf.sprintf "%s\n%s" (kind.show shape) (Draw.show_ray ray)

let show_answer = function
  | None -> "no hit"
  | Some { Crossing.t; side; part } ->
      Printf.sprintf "t = %h %s, part %d" t
        (match side with Outside -> "from outside" | Inside -> "from inside")
        part

let show_crossing (c : Crossing.t) =
  let t = Q.to_float (Exact_root.approximate c.at) in
  show_answer (Some { Crossing.t; side = c.side; part = c.part })

(* {1 Judging} *)

let judged kind ~ulps { shape; ray } =
  let truth = kind.truth shape (Line.of_ray ray) in
  let answer = kind.answer shape ray in
  (truth, answer, Crossing.judge ~ulps truth answer)

let is_right (v : Crossing.verdict) =
  match v with
  | Agrees | Excused -> true
  | False_miss | False_hit | Wrong_t | Wrong_side | Not_finite -> false

(* The simplest case that is wrong as well. *)
let rec shrunk wrong tree =
  match Seq.find (fun t -> wrong (Tree.root t)) (Tree.children tree) with
  | Some simpler -> shrunk wrong simpler
  | None -> Tree.root tree

let report kind ~ulps name i case =
  let truth, answer, verdict = judged kind ~ulps case in
  Printf.sprintf
    "%s: case %d of seed %d, made simpler:\n\
     %s\n\
     %s: the answer is %s, the truth %s, t to be within %g ulp"
    name i Law.seed (show kind case)
    (Crossing.show_verdict verdict)
    (show_answer answer)
    (Option.fold ~none:"no hit" ~some:show_crossing
       (Crossing.first truth.crossings))
    ulps

(** [source family] draws the cases of [family], the same in every run, each
    with the simpler ones that it shrinks to. *)
let source { name; cases } =
  let rand = Random.State.make [| Law.seed; Hashtbl.hash name |] in
  fun () -> Gen.generate_tree ~rand cases

(** [sample family n] are the first [n] of its cases. *)
let sample family n =
  let next = source family in
  Array.init n (fun _ -> Tree.root (next ()))

type outcome = { tally : Score.t; failure : string option  (** the first *) }

(** [run kind ~ulps ~count family] judges [count] cases, one after the other,
    with t to be within [ulps]; [observe] sees each of them too. *)
let run ?(observe = ignore) kind ~ulps ~count family =
  let tally = Score.make () and next = source family in
  let judge failure i =
    let tree = next () in
    let case = Tree.root tree in
    let truth, answer, verdict = judged kind ~ulps case in
    observe case;
    Score.verdict tally verdict;
    if verdict = Agrees then
      Option.iter (Score.error tally) (Crossing.error truth answer);
    match failure with
    | Some _ -> failure
    | None when is_right verdict -> None
    | None ->
        let wrong case =
          let _, _, verdict = judged kind ~ulps case in
          not (is_right verdict)
        in
        Some (report kind ~ulps family.name i (shrunk wrong tree))
  in
  let failure = Seq.fold_left judge None (Seq.take count (Seq.ints 1)) in
  { tally; failure }

(** [agrees name kind ~ulps family] is the example [name]: that the library
    agrees with the truth on the first cases of [family]. *)
let agrees ?(count = 2000) name kind ~ulps family =
  Law.example name (fun () ->
      let { failure; _ } = run kind ~ulps ~count:(count * Law.factor) family in
      Option.iter (fun why -> Alcotest.fail why) failure)

(** [decides name kind ~ulps case] is the same for one case. *)
let decides name kind ~ulps case =
  let drawn = { name; cases = Gen.return case } in
  agrees ~count:1 name kind ~ulps drawn

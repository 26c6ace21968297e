(** Families of cases, each planting one kind of difficulty, and what the
    library makes of them beside the exact truth. *)

type 'shape case = { shape : 'shape; ray : Candor_space.Ray.t }
type 'shape t = { name : string; cases : 'shape case QCheck2.Gen.t }

type 'shape kind = {
  show : 'shape -> string;
  answer : 'shape -> Candor_space.Ray.t -> Crossing.answer option;
  truth : 'shape -> Crossing.line -> Crossing.truth;
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

(** [agrees kind ~ulps family] is the law that the library agrees with the exact
    truth on [family], with t within [ulps]. *)
let agrees ?count kind ~ulps { name; cases } =
  Law.law ?count ~print:(show kind)
    (Printf.sprintf "%s: decided exactly, t within %g ulp" name ulps) cases
    (fun { shape; ray } ->
      let truth = kind.truth shape (Crossing.line ray) in
      let answer = kind.answer shape ray in
      match Crossing.judge ~ulps truth answer with
      | Agrees | Excused -> true
      | verdict ->
          Law.fail "%s: the answer is %s, the truth %s"
            (Crossing.show_verdict verdict)
            (show_answer answer)
            (show_answer
               (Option.map
                  (fun (c : Crossing.t) ->
                    {
                      Crossing.t = Q.to_float (Exact_root.approximate c.at);
                      side = c.side;
                      part = c.part;
                    })
                  (Crossing.first truth.crossings))))

(** [spread xs] is the median, the 99th percentile and the greatest of [xs]. *)
let spread xs =
  Array.sort Float.compare xs;
  let n = Array.length xs in
  let at p = if n = 0 then nan else xs.(Int.min (n - 1) (p * n / 100)) in
  Printf.sprintf "%8.3g %7.3g %8.3g" (at 50) (at 99) (at 100)

(** [figures kind ~count family] prints a line of what {!agrees} would judge. *)
let figures kind ~count { name; cases } =
  let rand = Random.State.make [| Law.seed; Hashtbl.hash name |] in
  let all = QCheck2.Gen.generate ~rand ~n:count cases in
  let tally = Hashtbl.create 8 and errors = ref [] in
  let judge { shape; ray } =
    let truth = kind.truth shape (Crossing.line ray) in
    let answer = kind.answer shape ray in
    let verdict = Crossing.judge ~ulps:1e6 truth answer in
    let n = Option.value ~default:0 (Hashtbl.find_opt tally verdict) in
    Hashtbl.replace tally verdict (n + 1);
    if verdict = Agrees then
      Option.iter
        (fun e -> errors := e :: !errors)
        (Crossing.error truth answer)
  in
  List.iter judge all;
  let errors = Array.of_list !errors in
  let of_kind v = Option.value ~default:0 (Hashtbl.find_opt tally v) in
  Printf.printf "%-64s %7d %7d %5d %5d %5d %5d %5d %5d  %s\n%!" name count
    (Array.length errors) (of_kind False_miss) (of_kind False_hit)
    (of_kind Wrong_side) (of_kind Wrong_t) (of_kind Not_finite)
    (of_kind Excused) (spread errors)

let heading name =
  Printf.printf "%-64s %7s %7s %5s %5s %5s %5s %5s %5s  %s\n" name "cases"
    "hits" "miss-" "hit-" "side-" "t-" "nan" "excus" "ulp: p50    p99      max"

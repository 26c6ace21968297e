(* An effect that a scene does not call for costs it nothing: whatever effects
   are added, what the table says of the scene stays so. *)

open Candor_effect
open Candor_oracle

(* A row of a table, its scene's plan and what it costs now. *)
type case = {
  stored : Stored.row;
  plan : Plan.t;
  now : Stored.row Lazy.t;
  has_words : bool;  (** whether words can be compared *)
}

(* Inlining decides what is allocated: profile and compiler matter. *)
let cases name =
  let table = Stored.read name in
  let has_words = Built.profile = "release" && Stored.same_compiler table in
  let case stored =
    let scene = Now.scene stored in
    let now = lazy (Now.measured stored scene) in
    { stored; plan = Plan.of_scene scene; now; has_words }
  in
  List.map case (Stored.measured table)

let stored = cases "costs"
let without e = List.filter (fun c -> not (Plan.is_on c.plan e)) stored

(* {1 Counters} *)

let get c (row : Stored.row) =
  Option.value (List.assoc_opt (Tally.name c) row.counts) ~default:0

(* Those that add to a counter. *)
let effects : Tally.counter -> Effect.t list = function
  | Camera_rays | Non_finite -> []
  | Shadow_rays -> [ Shadows ]
  | Mirror_rays -> [ Mirror ]
  | Refraction_rays -> [ Refraction ]
  | Bounce_rays -> [ Indirect ]
  | Emitter_rays -> [ Soft_shadows; Gloss ]
  | Sky_rays -> [ Sky_light ]
  | Scattered_rays -> [ Fog; Subsurface ]
  | Cut_by_depth | Cut_by_weight -> [ Mirror; Refraction; Indirect; Fog ]
  | Spared_samples -> [ Anti_aliasing ]

(* The counters of [e] that no effect of the plan adds to. *)
let silent plan e =
  List.filter
    (fun c ->
      let adders = effects c in
      List.exists (Effect.equal e) adders
      && not (List.exists (Plan.is_on plan) adders))
    Tally.counters

(* A sample that is spared would have been a ray from the camera. *)
let asked c row =
  if Tally.equal_counter c Camera_rays then get c row + get Spared_samples row
  else if Tally.equal_counter c Spared_samples then 0
  else get c row

let all_asked row =
  List.map (fun c -> (Tally.name c, asked c row)) Tally.counters

(* {1 What is checked} *)

let counts = Alcotest.(list (pair string int))

let no_counts e c (now : Stored.row) =
  let count counter = (Tally.name counter, get counter now) in
  let zero counter = (Tally.name counter, 0) in
  let silent = silent c.plan e in
  Alcotest.check counts "its counters" (List.map zero silent)
    (List.map count silent)

let same_bits c (now : Stored.row) =
  Alcotest.check counts "what was counted" (all_asked c.stored) (all_asked now);
  Alcotest.(check string) "digest" c.stored.digest now.digest

let no_more_words c (now : Stored.row) =
  let rays = List.fold_left (fun n r -> n + asked r c.stored) 0 Tally.rays in
  let per_ray words = float_of_int words /. float_of_int rays in
  if now.words > c.stored.words then
    Alcotest.failf "%.4f words per ray, where %.4f sufficed" (per_ray now.words)
      (per_ray c.stored.words)

let costs_nothing e c () =
  let now = Lazy.force c.now in
  no_counts e c now;
  same_bits c now;
  if c.has_words then no_more_words c now

let absent e c =
  Law.example
    (Printf.sprintf "in %s: same bits, %s" c.stored.scene
       (if c.has_words then "no more words"
        else "words not compared (another profile or OCaml)"))
    (costs_nothing e c)

let somewhere e () =
  if without e = [] then Alcotest.fail "every scene in the table calls for it"

let suite e =
  ( Effect.name e ^ " is off",
    Law.example "in some scene of the table" (somewhere e)
    :: List.map (absent e) (without e) )

let suites = List.map suite Effect.all

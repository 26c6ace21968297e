(** Laws and examples, as Alcotest cases.

    The cases of a law are the same in every run, unless CANDOR_SEED is set;
    CANDOR_CASES multiplies their number. *)

open QCheck2

let from_environment name default =
  match Option.bind (Sys.getenv_opt name) int_of_string_opt with
  | Some n -> n
  | None -> default

let factor = from_environment "CANDOR_CASES" 1
let seed = from_environment "CANDOR_SEED" 1
let example name f = Alcotest.test_case name `Quick f

(** [law ~print name gen holds] is the test that [holds] is true of everything
    that [gen] makes. *)
let law ?(count = 2000) ~print name gen holds =
  let rand = Random.State.make [| seed; Hashtbl.hash name |] in
  QCheck_alcotest.to_alcotest ~rand ~speed_level:`Quick
    (Test.make ~count:(count * factor) ~print ~name gen holds)

(** [fail format ...] makes a law fail with a message. *)
let fail format = Printf.ksprintf Test.fail_report format

(* Every family of a kind of surface against the exact truth.

   sweep.exe table CASES KIND prints what it finds; sweep.exe check CASES KIND
   speaks only of what is wrong. Either fails where a decision is wrong, or where
   a t or an offset is off by more than is promised. *)

open Candor_surface
open Candor_oracle
open Candor_surface_families

type 'shape subject = {
  kind : 'shape Family.kind;
  kernels : 'shape Speed.kernels;
  surface : 'shape -> unit Surface.t;
  exempt : 'shape -> Candor_space.Point.t -> bool;
      (* where offsets have no bound *)
  families : 'shape Family.t list;
}

type any = Any : 'shape subject -> any

let nowhere _ _ = false

(* A kind of surface with a kernel and a textbook's. *)
let simple ?(exempt = nowhere) kind meet textbook surface families =
  let kernels =
    {
      Speed.ours = Speed.alone (fun s r c -> meet s r Contact.none c);
      textbook = Some (Speed.plainly textbook);
    }
  in
  { kind; kernels; surface = (fun s -> surface s ()); exempt; families }

let subjects =
  let open Speed in
  let quadrics families =
    simple ~exempt:Offsets.at_apex Quadrics.kind Quadric.meet Textbook.quadric
      Surface.quadric families
  in
  [
    ( "sphere",
      Any
        (simple Spheres.kind Sphere.meet Textbook.sphere Surface.sphere
           Spheres.all) );
    ("box", Any (simple Boxes.kind Box.meet Textbook.box Surface.box Boxes.all));
    ( "triangle",
      Any
        (simple Triangles.kind Triangle.meet Textbook.triangle Surface.triangle
           Triangles.all) );
    ("quadric", Any (quadrics Quadrics.all));
    ("clip", Any (quadrics Clips.all));
    ( "polygon",
      Any
        {
          kind = Polygons.kind;
          kernels =
            { ours = query (fun s -> s.Polygons.surface); textbook = None };
          surface = (fun s -> s.Polygons.surface);
          exempt = nowhere;
          families = Polygons.all;
        } );
    ( "nested",
      Any
        {
          kind = Nested.kind ~blur:Promises.blur;
          kernels =
            { ours = query (fun s -> s.Nested.surface); textbook = None };
          surface = (fun s -> s.Nested.surface);
          exempt = nowhere;
          families = Nested.all;
        } );
  ]

(* Whether all is well with a family. *)
let family ~print kind ~count
    { kind = judge; kernels; surface; exempt; families = _ } family =
  let name = family.Family.name in
  let ulps = Promises.ulps kind name and within = Promises.offset kind name in
  let spawned = Score.make () and far = ref None in
  let observe case =
    if not (Offsets.judge spawned ~exempt surface ~within case) then
      far := Some case
  in
  let { Family.tally; failure } =
    Family.run ~observe judge ~ulps ~count family
  in
  if print then
    Printf.printf "%-64s %s %4.0f %s %s\n%!" name (Score.row tally) ulps
      (Offsets.row spawned) (Speed.row kernels family);
  Option.iter prerr_endline failure;
  Option.iter
    (fun case ->
      Printf.eprintf "%s: offsets up to %g u of the coordinates, not %g:\n%s\n"
        name spawned.greatest within (Family.show judge case))
    !far;
  Score.wrong tally = 0 && Option.is_none !far

let run ~print ~count kind =
  match List.assoc_opt kind subjects with
  | None ->
      let kinds = String.concat ", " (List.map fst subjects) in
      Printf.eprintf "no kind `%s`, only %s\n" kind kinds;
      false
  | Some (Any subject) ->
      if print then
        Printf.printf "%-64s %s %4s %s %s\n%!" kind Score.heading "may"
          Offsets.heading Speed.heading;
      List.map (family ~print kind ~count subject) subject.families
      |> List.for_all Fun.id

let () =
  let usage = "sweep.exe (table|check) CASES KIND" in
  match Array.to_list Sys.argv with
  | [ _; (("table" | "check") as what); cases; kind ] -> (
      match int_of_string_opt cases with
      | Some count when count > 0 ->
          if not (run ~print:(what = "table") ~count kind) then exit 1
      | _ ->
          prerr_endline usage;
          exit 2)
  | _ ->
      prerr_endline usage;
      exit 2

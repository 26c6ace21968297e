open Candor_scene

type t = {
  place : Place.t;
  message : string;
  hint : string option;
  excerpt : Excerpt.t option;
}

let pp_place ppf (p : Place.t) =
  Format.pp_print_string ppf (if p.line = 0 then p.file else Place.to_string p)

let pp_excerpt ppf line (e : Excerpt.t) =
  Format.fprintf ppf "%5d | %s@\n" line e.text;
  Format.fprintf ppf "      | %s%s@\n" (String.make e.indent ' ')
    (String.make e.width '^')

let pp ppf e =
  let hint = Option.fold e.hint ~none:"" ~some:(fun hint -> "; " ^ hint) in
  Format.fprintf ppf "%a: %s%s@\n" pp_place e.place e.message hint;
  Option.iter (pp_excerpt ppf e.place.line) e.excerpt

type report = { errors : t list; more : int }

let most = 50

let pp_report ppf r =
  let all = List.length r.errors + r.more in
  List.iter (pp ppf) r.errors;
  if r.more > 0 then Format.fprintf ppf "and %d more@\n" r.more;
  Format.fprintf ppf "%s@\n" (Quote.count all "error")

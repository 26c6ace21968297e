module Parser = Parsexp.Eager_and_positions

exception Stop of Fault.t

let stop ?hint span message = raise_notrace (Stop (Fault.v ?hint span message))

(* The scene's own opening parenthesis is skipped, so that each form within it
   is a top-level one to the parser, and the closing one a parse error. *)
type phase =
  | Head of Outline.t  (** before the parenthesis that opens the scene *)
  | Body of {
      parser : Parser.State.t;
      stack : Parser.Stack.t;
      scene : Span.t option ref;  (** the word [scene] once it has come *)
    }
  | Tail of { parser : Parser.State.t; stack : Parser.Stack.t; scene : Span.t }
      (** after the end of the scene *)

let parser span f =
  let receive (_ : Parser.State.Read_only.t) parsed =
    match Located.of_parsed parsed with
    | Ok form -> f form
    | Error (span, why) -> stop span why
  in
  let pos = Span.to_position span in
  Parser.State.create ~pos ~reraise_notrace:true receive

let not_a_scene span =
  stop span "expected (scene ...)"
    ~hint:"a scene file is one (scene ...) around all its forms"

let bare_body f span =
  let receive (form : Located.t) =
    match Located.head form with
    | Some "scene" ->
        stop form.span "an included file has no (scene ...) around its forms"
          ~hint:"move what both files need to a third"
    | Some _ | None -> f form
  in
  let parser = parser span receive in
  Body { parser; stack = Parser.Stack.empty; scene = ref (Some span) }

let scene_body f span =
  (* local mutation: it dies with the parser *)
  let scene = ref None in
  let receive (form : Located.t) =
    match (!scene, form.node) with
    | Some _, _ -> f form
    | None, Atom "scene" -> scene := Some form.span
    | None, (Atom _ | List _) -> not_a_scene form.span
  in
  Body { parser = parser span receive; stack = Parser.Stack.empty; scene }

let tail scene (closed : Span.t) =
  let receive (form : Located.t) =
    stop form.span "nothing may follow the end of (scene ...)"
      ~hint:(Printf.sprintf "it ends at %d:%d" closed.line closed.column)
  in
  let parser = parser (Span.after closed ')') receive in
  Tail { parser; stack = Parser.Stack.empty; scene }

let here = function
  | Head outline -> Outline.here outline
  | Body { parser; _ } | Tail { parser; _ } ->
      Span.of_position (Parser.State.position parser)

let rec advance ~bare f phase buffer ~first ~last =
  let next phase ~first = advance ~bare f phase buffer ~first ~last in
  let feed parser stack =
    Parser.feed_subbytes parser buffer stack ~pos:first ~len:(last - first)
  in
  if first >= last then phase
  else
    match phase with
    | Head outline -> (
        let outline' = Outline.feed outline (Bytes.get buffer first) in
        match Outline.unclosed outline' with
        | Parenthesis _ ->
            next (scene_body f (Outline.here outline')) ~first:(first + 1)
        | (Comment _ | Nothing) when Outline.is_blank outline' ->
            next (Head outline') ~first:(first + 1)
        | Comment _ | Nothing | Quotation _ -> not_a_scene (here phase))
    | Body ({ parser; stack; scene } as body) -> (
        let { Span.offset; _ } = here phase in
        match feed parser stack with
        | stack -> Body { body with stack }
        | exception Parsexp.Parse_error e
          when (not bare) && Fault.closes_nothing e -> (
            let closed = Span.of_position (Parsexp.Parse_error.position e) in
            match !scene with
            | None -> not_a_scene closed
            | Some scene ->
                next (tail scene closed)
                  ~first:(first + closed.offset - offset + 1)))
    | Tail ({ parser; stack; _ } as tail) ->
        Tail { tail with stack = feed parser stack }

let at_end parser stack =
  match Parser.feed_eoi parser stack with
  | () -> None
  | exception Parsexp.Parse_error e -> Some (Fault.of_parser e)

(* [ended phase] is the word [scene], or what was wrong. *)
let ended ~bare start phase =
  match phase with
  | Head _ ->
      Error (Fault.v start "there is nothing here: expected (scene ...)")
  | Body { parser; stack; scene } -> (
      match (at_end parser stack, !scene) with
      | None, Some scene when bare -> Ok scene
      | Some fault, _ -> Error fault
      | None, (Some _ | None) ->
          Error (Fault.v start "(scene ...) is never closed"))
  | Tail { parser; stack; scene } ->
      Option.fold (at_end parser stack) ~none:(Ok scene) ~some:Result.error

let byte_order_mark = "\xEF\xBB\xBF"

let start buffer n =
  let marked =
    n >= 3 && String.equal (Bytes.sub_string buffer 0 3) byte_order_mark
  in
  { Span.start with offset = (if marked then 3 else 0) }

let input source buffer =
  match Source.input source buffer with
  | Ok n -> n
  | Error why -> raise_notrace (Stop (Fault.unreadable why))

(* A NUL byte is no text. It also ends a device such as /dev/zero. *)
let read source ~bare f =
  let buffer = Bytes.create Source.most in
  let consume phase ~first ~last =
    let text =
      match Bytes.index_opt buffer '\000' with
      | Some nul when nul < last -> Int.max first nul
      | Some _ | None -> last
    in
    let phase = advance ~bare f phase buffer ~first ~last:text in
    if text < last then stop (here phase) "a scene holds no NUL bytes"
    else phase
  in
  let n = input source buffer in
  let start = start buffer n in
  let rec go phase ~first ~last =
    if last = 0 then phase
    else
      let phase = consume phase ~first ~last in
      go phase ~first:0 ~last:(input source buffer)
  in
  let phase =
    if bare then bare_body f start else Head (Outline.start ~bare start)
  in
  match ended ~bare start (go phase ~first:start.offset ~last:n) with
  | Ok scene -> scene
  | Error otherwise ->
      raise_notrace (Stop (Fault.unclosed source ~bare start ~otherwise))

let iter source ~bare f =
  match read source ~bare f with
  | scene -> Ok scene
  | exception Stop fault -> Error fault
  | exception Parsexp.Parse_error e -> Error (Fault.of_parser e)

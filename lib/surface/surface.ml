open Candor_space

type 'm t =
  | Sphere of Sphere.t * 'm
  | Box of Box.t * 'm
  | Triangle of Triangle.t * 'm
  | Quadric of Quadric.t * 'm
  | Group of 'm group

and 'm group = {
  transform : Transform.t option;
  members : 'm t Bvh.t;
  math : Math.t;
}

let sphere s m = Sphere (s, m)
let box b m = Box (b, m)
let triangle s m = Triangle (s, m)
let quadric q m = Quadric (q, m)

let bounds = function
  | Sphere (s, _) -> Sphere.bounds s
  | Box (b, _) -> Box.bounds b
  | Triangle (s, _) -> Triangle.bounds s
  | Quadric (q, _) -> Quadric.bounds q
  | Group { transform = None; members; _ } -> Bvh.bounds members
  | Group { transform = Some m; members; _ } ->
      Bounds.transform (Transform.forward m) (Bvh.bounds members)

let group ?(math = Math.Stable) members =
  Group { transform = None; members = Bvh.make ~bounds members; math }

let seen_through ?transform surface =
  match (surface, transform) with
  | Group _, None -> surface
  | Group ({ transform = None; _ } as g), Some _ -> Group { g with transform }
  | Group ({ transform = Some inner; _ } as g), Some outer ->
      Group { g with transform = Some (Transform.after outer inner) }
  | (Sphere _ | Box _ | Triangle _ | Quadric _), _ ->
      Group
        {
          transform;
          members = Bvh.make ~bounds [| surface |];
          math = Math.Stable;
        }

(* {1 Searching}

   A query is a walk over nested groups that carries the ray in the space of the
   group it is in. What is found is kept in two places that die with the query:
   the cursor and [best]. *)

type 'm search = {
  ray : Object_ray.t;
  math : Math.t;
  rest : int list;
      (* the way from here to the surface that the ray left; [] if none *)
  left : Contact.t; (* how the ray left it *)
  entered : entered list; (* the groups around, innermost first *)
  cursor : Cursor.t;
  best : 'm best;
}

and entered = { index : int; around : Transform.t option }
and 'm best = { mutable found : 'm found option }

and 'm found = {
  search : 'm search;
  place : int;
  surface : 'm t;
  contact : Contact.t;
}

let path entered place =
  List.fold_left (fun path group -> group.index :: path) [ place ] entered

let left search i =
  match search.rest with
  | [ k ] when k = i -> search.left
  | [] | _ :: _ -> Contact.none

let inside (group : _ group) ray =
  match (group.transform, group.math) with
  | None, _ -> ray
  | Some m, Stable -> Object_ray.through (Transform.backward m) ray
  | Some m, Textbook -> Textbook.group m ray

let enter search i group =
  let rest =
    match search.rest with
    | k :: (_ :: _ as rest) when k = i -> rest
    | [] | _ :: _ -> []
  in
  {
    search with
    ray = inside group search.ray;
    math = group.math;
    rest;
    entered = { index = i; around = group.transform } :: search.entered;
  }

let meet_stably search i surface =
  let { ray; cursor; _ } = search in
  let left = left search i in
  match surface with
  | Sphere (s, _) -> Sphere.meet s ray left cursor
  | Box (b, _) -> Box.meet b ray left cursor
  | Triangle (s, _) -> Triangle.meet s ray left cursor
  | Quadric (q, _) -> Quadric.meet q ray left cursor
  | Group _ -> Contact.none

let meet_by_textbook { ray; cursor; _ } surface =
  let o = ray.origin and d = ray.direction in
  match surface with
  | Sphere (s, _) -> Textbook.sphere s o d cursor
  | Box (b, _) -> Textbook.box b o d cursor
  | Triangle (s, _) -> Textbook.triangle s o d cursor
  | Quadric (q, _) -> Textbook.quadric q o d cursor
  | Group _ -> Contact.none

let meet search i surface =
  Cursor.tested search.cursor;
  match search.math with
  | Stable -> meet_stably search i surface
  | Textbook -> meet_by_textbook search surface

let visit group search test =
  Bvh.visit group.members search.ray search.cursor search test

(* The new contact is at the cursor's t. It replaces the best one unless that is
   at the same t and earlier in the scene. *)
let keep search i surface contact ~before =
  let ties =
    match search.best.found with
    | Some f when not (search.cursor.t < before) ->
        List.compare Int.compare
          (path f.search.entered f.place)
          (path search.entered i)
        < 0
    | Some _ | None -> false
  in
  if not ties then
    search.best.found <- Some { search; place = i; surface; contact }

let rec test_nearest search i surface =
  (match surface with
  | Group g -> ignore (visit g (enter search i g) test_nearest : bool)
  | Sphere _ | Box _ | Triangle _ | Quadric _ ->
      let before = search.cursor.t in
      let contact = meet search i surface in
      if not (Contact.is_none contact) then
        keep search i surface contact ~before);
  false

let rec test_blocked search i surface =
  match surface with
  | Group g -> visit g (enter search i g) test_blocked
  | Sphere _ | Box _ | Triangle _ | Quadric _ ->
      not (Contact.is_none (meet search i surface))

let valid (ray : Ray.t) limit =
  Point.is_finite ray.origin
  && Vec.is_finite ray.direction
  && Vec.largest ray.direction > 0.
  && limit > 0.

let math_of = function
  | Group { math; _ } -> math
  | Sphere _ | Box _ | Triangle _ | Quadric _ -> Math.Stable

(* The textbook's epsilon is a length, t is in units of the direction. *)
let least (math : Math.t) (ray : Ray.t) =
  match math with
  | Textbook -> Textbook.epsilon /. Vec.norm ray.direction
  | Stable -> 0.

let start surface (ray : Ray.t) limit =
  let rest, left =
    match ray.departure with
    | Nowhere -> ([], Contact.none)
    | Surface { path; part; side } -> (path, Contact.v ~part side)
  in
  let math = math_of surface in
  {
    ray = Object_ray.of_ray ray;
    math;
    rest;
    left;
    entered = [];
    cursor = Cursor.v ~least:(least math ray) limit;
    best = { found = None };
  }

(* A single surface is asked as the only member of a group whose own place does
   not count. *)
let run surface search test =
  match surface with
  | Group ({ transform = None; _ } as g) -> visit g search test
  | Sphere _ | Box _ | Triangle _ | Quadric _ | Group { transform = Some _; _ }
    ->
      test search 0 surface

let locate { search = { ray; math; _ }; surface; contact; _ } t =
  match (surface, math) with
  | Sphere (s, m), Stable -> Some (Sphere.locate s ray t contact, m)
  | Box (b, m), Stable -> Some (Box.locate b ray t contact, m)
  | Triangle (s, m), Stable -> Some (Triangle.locate s ray, m)
  | Quadric (q, m), Stable -> Some (Quadric.locate q ray t contact, m)
  | Sphere (s, m), Textbook -> Some (Textbook.locate_sphere s ray t contact, m)
  | Box (b, m), Textbook -> Some (Textbook.locate_box b ray t contact, m)
  | Triangle (s, m), Textbook -> Some (Textbook.locate_triangle s ray t, m)
  | Quadric (q, m), Textbook -> Some (Textbook.locate_quadric q ray t contact, m)
  | Group _, _ -> None

let hit found t =
  let { search = { entered; math; _ }; place; contact; _ } = found in
  let groups = List.filter_map (fun g -> g.around) entered in
  Option.map
    (fun (local, m) ->
      Hit.v ~t ~math contact local ~groups ~path:(path entered place) m)
    (locate found t)

let nearest surface ?(limit = infinity) ?effort ray =
  if not (valid ray limit) then None
  else
    let search = start surface ray limit in
    ignore (run surface search test_nearest : bool);
    Option.iter (Effort.add search.cursor) effort;
    Option.bind search.best.found (fun found -> hit found search.cursor.t)

let blocked surface ?effort ~limit ray =
  valid ray limit
  &&
  let search = start surface ray limit in
  let blocked = run surface search test_blocked in
  Option.iter (Effort.add search.cursor) effort;
  blocked

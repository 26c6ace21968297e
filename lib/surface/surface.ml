open Candor_space

type 'm t =
  | Sphere of Sphere.t * 'm
  | Box of Box.t * 'm
  | Triangle of Triangle.t * 'm
  | Quadric of Quadric.t * 'm
  | Group of 'm group
  | Moving of 'm moving

and 'm group = {
  transform : Transform.t option;
  members : 'm t Bvh.t;
  math : Math.t;
}

and 'm moving = { motion : Motion.t; still : 'm t }

let sphere s m = Sphere (s, m)
let box b m = Box (b, m)
let triangle s m = Triangle (s, m)
let quadric q m = Quadric (q, m)

let rec bounds = function
  | Sphere (s, _) -> Sphere.bounds s
  | Box (b, _) -> Box.bounds b
  | Triangle (s, _) -> Triangle.bounds s
  | Quadric (q, _) -> Quadric.bounds q
  | Group { transform = None; members; _ } -> Bvh.bounds members
  | Group { transform = Some m; members; _ } ->
      Bounds.transform (Transform.forward m) (Bvh.bounds members)
  | Moving { motion; still } -> Motion.sweep motion (bounds still)

let group ?(math = Math.Stable) members =
  Group { transform = None; members = Bvh.make ~bounds members; math }

let moving ~velocity ~shutter still =
  Moving { motion = Motion.v ~velocity ~shutter; still }

let seen_through ?transform surface =
  match (surface, transform) with
  | Group _, None -> surface
  | Group ({ transform = None; _ } as g), Some _ -> Group { g with transform }
  | Group ({ transform = Some inner; _ } as g), Some outer ->
      Group { g with transform = Some (Transform.after outer inner) }
  | (Sphere _ | Box _ | Triangle _ | Quadric _ | Moving _), _ ->
      Group
        {
          transform;
          members = Bvh.make ~bounds [| surface |];
          math = Math.Stable;
        }

let cover surface ~depth =
  match surface with
  | Group { transform = None; members; _ } -> Bvh.cover members ~depth
  | Group { transform = Some _; _ }
  | Sphere _ | Box _ | Triangle _ | Quadric _ | Moving _ ->
      [ bounds surface ]

(* {1 Searching}

   A query is a walk over nested groups that carries the ray in the space of the
   group it is in. What is found is kept in two places that die with the query:
   the cursor and [found]. *)

type 'm search = {
  ray : Object_ray.t;
  probe : Bvh.probe; (* of [ray] *)
  math : Math.t;
  rest : int list;
      (* the way from here to the surface that the ray left; [] if none *)
  way : Way.t; (* from the outside to here *)
  query : 'm query;
}

and 'm query = {
  left : Contact.t; (* how the ray left the surface at the end of [rest] *)
  cursor : Cursor.t;
  mutable found : 'm found;
}

and 'm found =
  | Nothing
  | Found of {
      search : 'm search;
      place : int;
      surface : 'm t;
      contact : Contact.t;
    }

let left search i =
  match search.rest with
  | [ k ] when k = i -> search.query.left
  | [] | _ :: _ -> Contact.none

let inside (group : _ group) ray =
  match (group.transform, group.math) with
  | None, _ -> ray
  | Some m, Stable -> Object_ray.through (Transform.backward m) ray
  | Some m, Textbook -> Textbook.group m ray

let enter { ray; probe; rest; way; query; _ } i group =
  let rest =
    match rest with
    | k :: (_ :: _ as rest) when k = i -> rest
    | [] | _ :: _ -> []
  in
  let here = inside group ray in
  {
    ray = here;
    probe = (if here == ray then probe else Bvh.probe here);
    math = group.math;
    rest;
    way = Within { index = i; transform = group.transform; around = way };
    query;
  }

(* No probe is asked for on the way to a single surface. *)
let follow search motion still =
  let by = Motion.displacement motion search.query.cursor.time in
  if Vec.equal by Vec.zero then search
  else
    let ray =
      match search.math with
      | Stable -> Motion.follow by search.ray
      | Textbook -> Textbook.moved by search.ray
    in
    let way = Way.Moved { by; around = search.way } in
    match still with
    | Group _ | Moving _ -> { search with ray; probe = Bvh.probe ray; way }
    | Sphere _ | Box _ | Triangle _ | Quadric _ -> { search with ray; way }

let meet_stably { ray; query = { cursor; _ }; _ } left surface =
  match surface with
  | Sphere (s, _) -> Sphere.meet s ray left cursor
  | Box (b, _) -> Box.meet b ray left cursor
  | Triangle (s, _) -> Triangle.meet s ray left cursor
  | Quadric (q, _) -> Quadric.meet q ray left cursor
  | Group _ | Moving _ -> Contact.none

let meet_by_textbook { ray; query = { cursor; _ }; _ } surface =
  let o = ray.origin and d = ray.direction in
  match surface with
  | Sphere (s, _) -> Textbook.sphere s o d cursor
  | Box (b, _) -> Textbook.box b o d cursor
  | Triangle (s, _) -> Textbook.triangle s o d cursor
  | Quadric (q, _) -> Textbook.quadric q o d cursor
  | Group _ | Moving _ -> Contact.none

let meet search i surface =
  Cursor.tested search.query.cursor;
  match search.math with
  | Stable -> meet_stably search (left search i) surface
  | Textbook -> meet_by_textbook search surface

let visit group search test =
  Bvh.visit group.members search.probe search.query.cursor search test

(* Whether a place comes before that of what was found so far. *)
let earlier search i =
  match search.query.found with
  | Nothing -> true
  | Found f ->
      List.compare Int.compare (Way.path search.way i)
        (Way.path f.search.way f.place)
      <= 0

let rec test_nearest search i surface =
  match surface with
  | Group g -> visit g (enter search i g) test_nearest
  | Moving { motion; still } ->
      test_nearest (follow search motion still) i still
  | Sphere _ | Box _ | Triangle _ | Quadric _ ->
      let query = search.query in
      let before = query.cursor.t in
      let contact = meet search i surface in
      if
        (not (Contact.is_none contact))
        && (query.cursor.t < before || earlier search i)
      then query.found <- Found { search; place = i; surface; contact };
      false

let rec test_blocked search i surface =
  match surface with
  | Group g -> visit g (enter search i g) test_blocked
  | Moving { motion; still } ->
      test_blocked (follow search motion still) i still
  | Sphere _ | Box _ | Triangle _ | Quadric _ ->
      not (Contact.is_none (meet search i surface))

let rec test_any kind search i surface =
  match surface with
  | Group g -> visit g (enter search i g) (test_any kind)
  | Moving { motion; still } ->
      test_any kind (follow search motion still) i still
  | Sphere (_, m) | Box (_, m) | Triangle (_, m) | Quadric (_, m) ->
      kind m && not (Contact.is_none (meet search i surface))

let valid (ray : Ray.t) limit =
  Point.is_finite ray.origin
  && Vec.is_finite ray.direction
  && Vec.largest ray.direction > 0.
  && limit > 0.

let rec math_of = function
  | Group { math; _ } -> math
  | Moving { still; _ } -> math_of still
  | Sphere _ | Box _ | Triangle _ | Quadric _ -> Math.Stable

(* The textbook's epsilon is a length, t is in units of the direction. *)
let cursor (math : Math.t) ?time (ray : Ray.t) limit =
  match math with
  | Textbook ->
      let least = Textbook.epsilon /. Vec.norm ray.direction in
      Cursor.v ~least ?time limit
  | Stable -> Cursor.v ?time limit

let start surface ?time (ray : Ray.t) limit =
  let rest, left =
    match ray.departure with
    | Nowhere -> ([], Contact.none)
    | Surface { path; part; side } -> (path, Contact.v ~part side)
  in
  let math = math_of surface in
  let cursor = cursor math ?time ray limit in
  let ray = Object_ray.of_ray ray in
  {
    ray;
    probe = Bvh.probe ray;
    math;
    rest;
    way = Outermost;
    query = { left; cursor; found = Nothing };
  }

(* A single surface is asked as the only member of a group whose own place does
   not count. *)
let run surface search test =
  match surface with
  | Group ({ transform = None; _ } as g) -> visit g search test
  | Group { transform = Some _; _ }
  | Sphere _ | Box _ | Triangle _ | Quadric _ | Moving _ ->
      test search 0 surface

let locate (math : Math.t) surface ray t contact =
  match (surface, math) with
  | Sphere (s, m), Stable -> Some (Sphere.locate s ray t contact, m)
  | Box (b, m), Stable -> Some (Box.locate b ray t contact, m)
  | Triangle (s, m), Stable -> Some (Triangle.locate s ray, m)
  | Quadric (q, m), Stable -> Some (Quadric.locate q ray t contact, m)
  | Sphere (s, m), Textbook -> Some (Textbook.locate_sphere s ray t contact, m)
  | Box (b, m), Textbook -> Some (Textbook.locate_box b ray t contact, m)
  | Triangle (s, m), Textbook -> Some (Textbook.locate_triangle s ray t, m)
  | Quadric (q, m), Textbook -> Some (Textbook.locate_quadric q ray t contact, m)
  | (Group _ | Moving _), _ -> None

let hit query =
  match query.found with
  | Nothing -> None
  | Found { search = { ray; math; way; _ }; place; surface; contact } -> (
      let t = query.cursor.t in
      match locate math surface ray t contact with
      | None -> None
      | Some (local, m) -> Some (Hit.v ~t ~math contact local way place m))

let count cursor = function
  | None -> ()
  | Some effort -> Effort.add cursor effort

let nearest surface ?(limit = infinity) ?time ?effort ray =
  if not (valid ray limit) then None
  else
    let search = start surface ?time ray limit in
    ignore (run surface search test_nearest : bool);
    count search.query.cursor effort;
    hit search.query

let blocked surface ?time ?effort ~limit ray =
  valid ray limit
  &&
  let search = start surface ?time ray limit in
  let blocked = run surface search test_blocked in
  count search.query.cursor effort;
  blocked

let meets_any surface ?time ?effort kind ray =
  valid ray infinity
  &&
  let search = start surface ?time ray infinity in
  let met = run surface search (test_any kind) in
  count search.query.cursor effort;
  met

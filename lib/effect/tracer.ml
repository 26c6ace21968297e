open Candor_space
open Candor_optics
open Candor_surface

type hit = Skin.t Hit.t

type t = {
  nearest : Tally.t -> Path.t -> Ray.t -> hit option;
  within : Tally.t -> Path.t -> limit:float -> Ray.t -> hit option;
  blocked : Tally.t -> Path.t -> limit:float -> Ray.t -> bool;
  meets_any : Tally.t -> Path.t -> (Skin.t -> bool) -> Ray.t -> bool;
}

let still surface =
  {
    nearest =
      (fun tally _ ray ->
        Surface.nearest surface ~effort:(Tally.effort tally) ray);
    within =
      (fun tally _ ~limit ray ->
        Surface.nearest surface ~limit ~effort:(Tally.effort tally) ray);
    blocked =
      (fun tally _ ~limit ray ->
        Surface.blocked surface ~effort:(Tally.effort tally) ~limit ray);
    meets_any =
      (fun tally _ kind ray ->
        Surface.meets_any surface ~effort:(Tally.effort tally) kind ray);
  }

let moving surface =
  {
    nearest =
      (fun tally (path : Path.t) ray ->
        let effort = Tally.effort tally and time = path.journey.time in
        Surface.nearest surface ~time ~effort ray);
    within =
      (fun tally path ~limit ray ->
        let effort = Tally.effort tally and time = path.journey.time in
        Surface.nearest surface ~limit ~time ~effort ray);
    blocked =
      (fun tally path ~limit ray ->
        let effort = Tally.effort tally and time = path.journey.time in
        Surface.blocked surface ~time ~effort ~limit ray);
    meets_any =
      (fun tally (path : Path.t) kind ray ->
        let effort = Tally.effort tally and time = path.journey.time in
        Surface.meets_any surface ~time ~effort kind ray);
  }

open Candor_scene
open Candor_effect
open Candor_trace
open Candor_image

type samples =
  | Uniform of int
  | Map of Sample_map.t
  | Adaptive of Adaptive.target

type aim = {
  target : Adaptive.target;
  ending : Adaptive.ending;
  forecasts : Forecast.t list;
}

type report = {
  picture : Picture.t;
  window : Window.t;
  map : Sample_map.t;
  sampling : Sampling.t;
  cut_off : Cut_off.t Lazy.t;
  aim : aim option;
  seconds : float;
  domains : int;
  tally : Tally.t;
  words : float;
  non_finite_pixel : (int * int) option;
}

type job = {
  domains : int;
  stop : unit -> bool;
  progress : Pace.t -> unit;
  window : Window.t;
  pixel : Pixel.t;
}

let row job i =
  let { Window.x0; x1; y0; _ } = job.window in
  Row.make ~x0 ~x1 (y0 + i)

let complete rows =
  if Array.for_all Option.is_some rows then
    Some (Array.of_list (List.filter_map Fun.id (Array.to_list rows)))
  else None

let parallel job f =
  let height = Window.height job.window in
  complete (Rows.parallel ~domains:job.domains ~stop:job.stop height f)

(* {1 Given numbers of samples} *)

(* Rows come and go: their sums are not kept. *)
let given job samples =
  let count = Window.height job.window in
  let times = Atomic.make [] in
  let rec note t =
    let before = Atomic.get times in
    if Atomic.compare_and_set times before (t :: before) then t :: before
    else note t
  in
  parallel job (fun i ->
      let clock = Clock.start () in
      let row = row job i in
      Row.take job.pixel row (samples i);
      let result = Row.result row in
      let seconds = note (Clock.seconds clock) in
      job.progress (Pace.of_parts ~count ~seconds);
      result)

let mapped (job : job) map =
  let { Window.x0; y0; _ } = job.window in
  given job (fun i k -> Sample_map.samples map (x0 + k) (y0 + i))

(* What has to be rendered for [window] is more where pixels have no samples. *)
let needed map window =
  if Sample_map.least map > 0 then window
  else Stand_in.window (Stand_in.of_map map) window

(* {1 Adaptive ones} *)

let adaptive job target =
  let rows = Array.init (Window.height job.window) (row job) in
  let taken = Atomic.make 0 and expected = Atomic.make None in
  let note more =
    let taken = Atomic.fetch_and_add taken more + more in
    match Atomic.get expected with
    | None -> ()
    | Some forecast ->
        job.progress (Pace.of_forecast ~taken:(float_of_int taken) forecast)
  in
  let { Window.x0; y0; _ } = job.window in
  let pass wanted =
    let take i =
      let row = rows.(i) in
      let before = Row.total row in
      Row.take job.pixel row (fun k -> wanted (x0 + k) (y0 + i));
      note (Row.total row - before)
    in
    Option.map (fun (_ : unit array) -> ()) (parallel job take)
  in
  Adaptive.run job.window rows target ~pass ~expect:(fun f ->
      Atomic.set expected (Some f))

(* {1 Reports} *)

(* The picture of [window], made of rows of [job]. *)
let shown (job : job) map window =
  let of_rows = Picture.of_rows ~width:(Window.width job.window) in
  if Sample_map.least map > 0 then of_rows
  else
    let stand_in = Stand_in.of_map map in
    let width = Window.width window and height = Window.height window in
    fun rows ->
      let all = of_rows rows in
      Picture.init ~width ~height (fun x y ->
          let x, y = Stand_in.pixel stand_in (window.x0 + x) (window.y0 + y) in
          Picture.pixel all (x - job.window.x0) (y - job.window.y0))

let report (job : job) (scene : Scene.t) ~window ~seconds ~aim results =
  let list = Array.to_list results in
  let rows f = Array.map f results in
  let map =
    Sample_map.v ~width:scene.width ~height:scene.height ~spp:scene.settings.spp
      job.window
      (rows (fun (r : Row.result) -> r.counts))
  in
  let shown = shown job map window in
  let picture = shown (rows (fun (r : Row.result) -> r.pixels))
  and cut = shown (rows (fun (r : Row.result) -> r.cut)) in
  {
    picture;
    cut_off = lazy (Cut_off.of_picture (Brightest.of_scene scene) ~cut picture);
    window;
    map;
    sampling = Sampling.sum Row.sampling results;
    aim;
    seconds;
    domains = job.domains;
    tally = Tally.sum (List.map (fun (r : Row.result) -> r.tally) list);
    words = List.fold_left (fun sum (r : Row.result) -> sum +. r.words) 0. list;
    non_finite_pixel = List.find_map (fun (r : Row.result) -> r.non_finite) list;
  }

let run ?(domains = Rows.most_domains ()) ?(stop = fun () -> false)
    ?(progress = ignore) ?window ?samples pixel (scene : Scene.t) =
  let window = Option.value window ~default:(Window.full scene) in
  let job = { domains; stop; progress; window; pixel } in
  let clock = Clock.start () in
  let report job ~aim rows =
    report job scene ~window ~seconds:(Clock.seconds clock) ~aim rows
  in
  match Option.value samples ~default:(Uniform scene.settings.spp) with
  | Uniform n -> Option.map (report job ~aim:None) (given job (fun _ _ -> n))
  | Map map ->
      let job = { job with window = needed map window } in
      Option.map (report job ~aim:None) (mapped job map)
  | Adaptive target ->
      Option.map
        (fun { Adaptive.results; ending; forecasts } ->
          report job ~aim:(Some { target; ending; forecasts }) results)
        (adaptive job target)

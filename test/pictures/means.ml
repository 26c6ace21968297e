(** Pictures as the means of square blocks of pixels, with standard errors. *)

open Candor_colour
open Candor_image

type block = { mean : Rgb.t; error : Rgb.t }

type t = {
  width : int;
  height : int;
  side : int;  (** of a block, in pixels *)
  blocks : block array;  (** row by row *)
}

(** [read file] is what [file] holds: a comment, [width height side], and a line
    of six numbers for each block. *)
let read file =
  let lines =
    In_channel.with_open_bin file In_channel.input_all
    |> String.split_on_char '\n'
    |> List.filter (fun l -> l <> "" && l.[0] <> ';')
  in
  let block line =
    Scanf.sscanf line "%f %f %f %f %f %f" (fun r g b r' g' b' ->
        { mean = Rgb.v r g b; error = Rgb.v r' g' b' })
  in
  match lines with
  | [] -> invalid_arg (file ^ " is empty")
  | size :: blocks ->
      Scanf.sscanf size "%d %d %d" (fun width height side ->
          {
            width;
            height;
            side;
            blocks = Array.of_list (List.map block blocks);
          })

let channels (c : Rgb.t) = [| c.r; c.g; c.b |]

(* Sums over the pixels of one block, channel by channel, of their mean over
   the pictures and of the variance of that. *)
let sums side pictures x0 y0 =
  let n = float_of_int (List.length pictures) in
  let mean = Array.make 3 0. and variance = Array.make 3 0. in
  for i = 0 to (side * side) - 1 do
    let x = x0 + (i mod side) and y = y0 + (i / side) in
    let values = List.map (fun p -> channels (Picture.pixel p x y)) pictures in
    for c = 0 to 2 do
      let total f = List.fold_left (fun s v -> s +. f v.(c)) 0. values in
      let m = total Fun.id /. n in
      mean.(c) <- mean.(c) +. m;
      variance.(c) <-
        variance.(c) +. (total (fun v -> (v -. m) ** 2.) /. (n *. (n -. 1.)))
    done
  done;
  (mean, variance)

(** [of_pictures ~side ps] is the mean of the pictures [ps], independent and of
    one size, with errors from how they differ. *)
let of_pictures ~side pictures =
  let first = List.hd pictures in
  let width = Picture.width first and height = Picture.height first in
  let columns = width / side in
  let area = float_of_int (side * side) in
  let block i =
    let mean, variance =
      sums side pictures (i mod columns * side) (i / columns * side)
    in
    let rgb f = Rgb.v (f 0) (f 1) (f 2) in
    {
      mean = rgb (fun c -> mean.(c) /. area);
      error = rgb (fun c -> sqrt variance.(c) /. area);
    }
  in
  let blocks = Array.init (columns * (height / side)) block in
  { width; height; side; blocks }

(** [scores a b] are the differences of all blocks and channels of [a] and [b]
    in standard errors. *)
let scores a b =
  let z x y =
    let difference c = (channels x.mean).(c) -. (channels y.mean).(c)
    and error c = Float.hypot (channels x.error).(c) (channels y.error).(c) in
    let one c =
      if error c > 0. then Some (difference c /. error c)
      else if difference c = 0. then None
      else Some infinity
    in
    List.filter_map one [ 0; 1; 2 ]
  in
  List.concat (Array.to_list (Array.map2 z a.blocks b.blocks))

(** [noise ps] is the RMS error of one of the pictures [ps], independent and of
    one scene, from how they differ. *)
let noise pictures =
  let n = float_of_int (List.length pictures) in
  let first = List.hd pictures in
  let width = Picture.width first and height = Picture.height first in
  let of_pixel i =
    let _, variance = sums 1 pictures (i mod width) (i / width) in
    Array.fold_left ( +. ) 0. variance
  in
  let total = ref 0. in
  for i = 0 to (width * height) - 1 do
    total := !total +. of_pixel i
  done;
  sqrt (n *. !total /. float_of_int (3 * width * height))

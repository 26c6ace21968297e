open Candor_space
open Candor_colour
open Candor_sample

type t = {
  value : Lobes.t -> normal:Dir.t -> view:Dir.t -> toward:Dir.t -> Rgb.t;
  density : Lobes.t -> normal:Dir.t -> view:Dir.t -> toward:Dir.t -> float;
  sample :
    Lobes.t ->
    normal:Dir.t ->
    view:Dir.t ->
    choice:float ->
    Pattern.position ->
    Gloss.sample option;
  is_black : Lobes.t -> bool;
}

let highlight (h : Lobes.highlight) ~normal ~(view : Dir.t) ~(toward : Dir.t) =
  let half = Vec.add (view :> Vec.t) (toward :> Vec.t) in
  let cos = Dir.dot normal (Dir.of_vec_or normal half) in
  Rgb.scale (Float.max 0. cos ** h.shininess) h.specular

let matte_value (lobes : Lobes.t) ~normal ~view ~toward =
  let cos = Dir.dot normal toward in
  if not (cos > 0.) then Rgb.black
  else
    let matte = Rgb.scale (cos /. Float.pi) lobes.diffuse in
    match lobes.highlight with
    | None -> matte
    | Some h -> Rgb.add matte (highlight h ~normal ~view ~toward)

let matte_density (lobes : Lobes.t) ~normal ~view:_ ~toward =
  if Rgb.is_black lobes.diffuse then 0.
  else Warp.cosine_hemisphere_density (Dir.dot normal toward)

let matte_sample (lobes : Lobes.t) ~normal ~view:_ ~choice:_ p =
  if Rgb.is_black lobes.diffuse then None
  else
    let local = Warp.cosine_hemisphere p in
    let toward = Warp.to_world (Frame.of_dir normal) (local :> Vec.t) in
    let density = Warp.cosine_hemisphere_density (Dir.dot normal toward) in
    if density > 0. then Some { Gloss.toward; weight = lobes.diffuse; density }
    else None

let is_matte_black (lobes : Lobes.t) =
  Rgb.is_black lobes.diffuse && Option.is_none lobes.highlight

let matte =
  {
    value = matte_value;
    density = matte_density;
    sample = matte_sample;
    is_black = is_matte_black;
  }

let glossy =
  {
    value =
      (fun lobes ~normal ~view ~toward ->
        match lobes.gloss with
        | None -> matte_value lobes ~normal ~view ~toward
        | Some gloss -> Gloss.value gloss ~normal ~view ~toward);
    density =
      (fun lobes ~normal ~view ~toward ->
        match lobes.gloss with
        | None -> matte_density lobes ~normal ~view ~toward
        | Some gloss -> Gloss.density gloss ~normal ~view ~toward);
    sample =
      (fun lobes ~normal ~view ~choice p ->
        match lobes.gloss with
        | None -> matte_sample lobes ~normal ~view ~choice p
        | Some gloss -> Gloss.sample gloss ~normal ~view ~choice ~u:p.u ~v:p.v);
    is_black = (fun lobes -> is_matte_black lobes && Option.is_none lobes.gloss);
  }

type t = Primitives.t

let of_scene scene =
  Primitives.of_scene ~keep:(fun _ m -> Material.emits m) scene

let radiance (e : t) = e.material.emission

type t =
  | Emission
  | Ambient
  | Direct
  | Shadows
  | Soft_shadows
  | Sky_light
  | Mirror
  | Refraction
  | Dispersion
  | Absorption
  | Subsurface
  | Gloss
  | Indirect
  | Fog
  | Depth_of_field
  | Motion_blur
  | Textures
  | Smooth_normals
  | Anti_aliasing
[@@deriving show, eq, ord]

let all =
  [
    Emission;
    Ambient;
    Direct;
    Shadows;
    Soft_shadows;
    Sky_light;
    Mirror;
    Refraction;
    Dispersion;
    Absorption;
    Subsurface;
    Gloss;
    Indirect;
    Fog;
    Depth_of_field;
    Motion_blur;
    Textures;
    Smooth_normals;
    Anti_aliasing;
  ]

let name = function
  | Emission -> Emission.name
  | Ambient -> Ambient.name
  | Direct -> Direct.name
  | Shadows -> Shadows.name
  | Soft_shadows -> Soft_shadows.name
  | Sky_light -> Sky_light.name
  | Mirror -> Mirror.name
  | Refraction -> Refraction.name
  | Dispersion -> Dispersion.name
  | Absorption -> Absorption.name
  | Subsurface -> Subsurface.name
  | Gloss -> Glossy.name
  | Indirect -> Indirect.name
  | Fog -> Fog.name
  | Depth_of_field -> Depth_of_field.name
  | Motion_blur -> Motion_blur.name
  | Textures -> Textures.name
  | Smooth_normals -> Smooth_normals.name
  | Anti_aliasing -> Anti_aliasing.name

let meaning = function
  | Emission -> Emission.meaning
  | Ambient -> Ambient.meaning
  | Direct -> Direct.meaning
  | Shadows -> Shadows.meaning
  | Soft_shadows -> Soft_shadows.meaning
  | Sky_light -> Sky_light.meaning
  | Mirror -> Mirror.meaning
  | Refraction -> Refraction.meaning
  | Dispersion -> Dispersion.meaning
  | Absorption -> Absorption.meaning
  | Subsurface -> Subsurface.meaning
  | Gloss -> Glossy.meaning
  | Indirect -> Indirect.meaning
  | Fog -> Fog.meaning
  | Depth_of_field -> Depth_of_field.meaning
  | Motion_blur -> Motion_blur.meaning
  | Textures -> Textures.meaning
  | Smooth_normals -> Smooth_normals.meaning
  | Anti_aliasing -> Anti_aliasing.meaning

let calls = function
  | Emission -> Emission.calls
  | Ambient -> Ambient.calls
  | Direct -> Direct.calls
  | Shadows -> Shadows.calls
  | Soft_shadows -> Soft_shadows.calls
  | Sky_light -> Sky_light.calls
  | Mirror -> Mirror.calls
  | Refraction -> Refraction.calls
  | Dispersion -> Dispersion.calls
  | Absorption -> Absorption.calls
  | Subsurface -> Subsurface.calls
  | Gloss -> Glossy.calls
  | Indirect -> Indirect.calls
  | Fog -> Fog.calls
  | Depth_of_field -> Depth_of_field.calls
  | Motion_blur -> Motion_blur.calls
  | Textures -> Textures.calls
  | Smooth_normals -> Smooth_normals.calls
  | Anti_aliasing -> Anti_aliasing.calls

let rays = function
  | Shadows -> Some Tally.Shadow_rays
  | Soft_shadows -> Some Emitter_rays
  | Sky_light -> Some Sky_rays
  | Mirror -> Some Mirror_rays
  | Refraction -> Some Refraction_rays
  | Indirect -> Some Bounce_rays
  | Emission | Ambient | Direct | Dispersion | Absorption | Subsurface | Gloss
  | Fog | Depth_of_field | Motion_blur | Textures | Smooth_normals
  | Anti_aliasing ->
      None

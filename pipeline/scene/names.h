// Names of a scene's enumerations, each with the word of the command line and of reports.
#pragma once

#include "pipeline/names.h"
#include "pipeline/scene/render_scene.h"
#include "pipeline/scene/scene.h"

namespace barrido {

template <>
inline constexpr auto kNames<scene::Light::Kind> =
    std::to_array<Named<scene::Light::Kind>>({{scene::Light::Kind::directional, "directional"},
                                              {scene::Light::Kind::point, "point"},
                                              {scene::Light::Kind::spot, "spot"}});

template <>
inline constexpr auto kNames<scene::UserLight::Space> = std::to_array<Named<scene::UserLight::Space>>(
    {{scene::UserLight::Space::world, "world", "the world"},
     {scene::UserLight::Space::camera, "camera", "the camera"}});

template <>
inline constexpr auto kNames<scene::SolidTexture::Space> = std::to_array<Named<scene::SolidTexture::Space>>(
    {{scene::SolidTexture::Space::object, "object", "the object"},
     {scene::SolidTexture::Space::world, "world", "the world"},
     {scene::SolidTexture::Space::surface, "surface", "the surface's (u, v)"}});

template <>
inline constexpr auto kNames<scene::Feature::Support> =
    std::to_array<Named<scene::Feature::Support>>({{scene::Feature::Support::exact, "exact"},
                                                   {scene::Feature::Support::approximated, "approximated"},
                                                   {scene::Feature::Support::ignored, "ignored"}});

template <>
inline constexpr auto kNames<scene::Transparency> =
    std::to_array<Named<scene::Transparency>>({{scene::Transparency::sorted, "sorted", "triangles sorted"},
                                               {scene::Transparency::exact, "exact", "exact in each pixel"}});

template <>
inline constexpr auto kNames<scene::ColorManagement> =
    std::to_array<Named<scene::ColorManagement>>({{scene::ColorManagement::srgb, "srgb", "managed (sRGB)"},
                                                  {scene::ColorManagement::none, "none", "as stored"}});

template <>
inline constexpr auto kNames<scene::Sampling> =
    std::to_array<Named<scene::Sampling>>({{scene::Sampling::uniform, "uniform"},
                                           {scene::Sampling::jittered, "jittered"},
                                           {scene::Sampling::adaptive, "adaptive"}});

}  // namespace barrido

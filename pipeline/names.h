// Names of the pipeline's enumerations, each with the word of the command line and of stories.
#pragma once

#include "pipeline/state.h"
#include "raster/names.h"

namespace barrido {

template <>
inline constexpr auto kNames<pipeline::ShadeModel> = []<std::size_t... rows>(std::index_sequence<rows...>) {
  return std::array<Named<pipeline::ShadeModel>, sizeof...(rows)>{
      {{pipeline::kShadingModes[rows].model, pipeline::kShadingModes[rows].name,
        pipeline::kShadingModes[rows].words}...}};
}
(std::make_index_sequence<pipeline::kShadingModeCount>());

template <>
inline constexpr auto kNames<pipeline::FlatAt> = std::to_array<Named<pipeline::FlatAt>>(
    {{pipeline::FlatAt::centroid, "centroid"},
     {pipeline::FlatAt::provoking_vertex, "provoking", "provoking vertex"}});

template <>
inline constexpr auto kNames<pipeline::CheapPhongPower> = std::to_array<Named<pipeline::CheapPhongPower>>(
    {{pipeline::CheapPhongPower::pixel, "pixel"}, {pipeline::CheapPhongPower::vertex, "vertex"}});

template <>
inline constexpr auto kNames<pipeline::SpecularModel> =
    std::to_array<Named<pipeline::SpecularModel>>({{pipeline::SpecularModel::phong, "phong", "R·V (Phong)"},
                                                   {pipeline::SpecularModel::blinn, "blinn", "N·H (Blinn)"}});

template <>
inline constexpr auto kNames<pipeline::ColorInterpolation> =
    std::to_array<Named<pipeline::ColorInterpolation>>(
        {{pipeline::ColorInterpolation::perspective, "perspective"},
         {pipeline::ColorInterpolation::screen, "screen", "linear on screen"}});

template <>
inline constexpr auto kNames<pipeline::TextureInterpolation> =
    std::to_array<Named<pipeline::TextureInterpolation>>(
        {{pipeline::TextureInterpolation::perspective, "perspective"},
         {pipeline::TextureInterpolation::affine, "affine"}});

template <>
inline constexpr auto kNames<pipeline::CullFace> =
    std::to_array<Named<pipeline::CullFace>>({{pipeline::CullFace::none, "none"},
                                              {pipeline::CullFace::back, "back"},
                                              {pipeline::CullFace::front, "front"},
                                              {pipeline::CullFace::front_and_back, "front-and-back"}});

}  // namespace barrido

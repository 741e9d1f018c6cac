// Names of the rasterizer's enumerations, each with the word of the command line and of stories.
#pragma once

#include "raster/base/enum_names.h"
#include "raster/fragments/fragment_state.h"
#include "raster/fragments/primitive.h"
#include "raster/textures/texture.h"
#include "raster/tiles/framebuffer.h"
#include "raster/tiles/samples.h"

namespace barrido {

template <>
inline constexpr auto kNames<raster::Topology> =
    std::to_array<Named<raster::Topology>>({{raster::Topology::points, "point"},
                                            {raster::Topology::lines, "line"},
                                            {raster::Topology::triangles, "triangle"}});

template <>
inline constexpr auto kNames<raster::MinFilter> = std::to_array<Named<raster::MinFilter>>(
    {{raster::MinFilter::nearest, "nearest"},
     {raster::MinFilter::linear, "linear"},
     {raster::MinFilter::nearest_mipmap_nearest, "nearest-mipmap-nearest", "nearest mip nearest"},
     {raster::MinFilter::linear_mipmap_nearest, "linear-mipmap-nearest", "linear mip nearest"},
     {raster::MinFilter::nearest_mipmap_linear, "nearest-mipmap-linear", "nearest mip linear"},
     {raster::MinFilter::linear_mipmap_linear, "linear-mipmap-linear", "linear mip linear"},
     {raster::MinFilter::footprint, "footprint", "mean of the footprint"},
     {raster::MinFilter::corners, "corners", "mean of its corners"}});

template <>
inline constexpr auto kNames<raster::MagFilter> = std::to_array<Named<raster::MagFilter>>(
    {{raster::MagFilter::nearest, "nearest"}, {raster::MagFilter::linear, "linear"}});

template <>
inline constexpr auto kNames<raster::PatternKind> =
    std::to_array<Named<raster::PatternKind>>({{raster::PatternKind::stripes, "stripes"},
                                               {raster::PatternKind::checker, "checker"},
                                               {raster::PatternKind::noise, "noise"},
                                               {raster::PatternKind::wood, "wood"},
                                               {raster::PatternKind::marble, "marble"}});

/// `none` stands last: who asks for a mapping asks for one of the others.
template <>
inline constexpr auto kNames<raster::MappingSurface> = std::to_array<Named<raster::MappingSurface>>(
    {{raster::MappingSurface::planar, "planar", "a plane"},
     {raster::MappingSurface::cylinder, "cylinder", "a cylinder"},
     {raster::MappingSurface::sphere, "sphere", "a sphere"},
     {raster::MappingSurface::box, "box", "a box"},
     {raster::MappingSurface::none, "none"}});

template <>
inline constexpr auto kNames<raster::MappingRay> = std::to_array<Named<raster::MappingRay>>(
    {{raster::MappingRay::surface, "surface", "the surface's normal"},
     {raster::MappingRay::centre, "centre", "the object's centre"},
     {raster::MappingRay::normal, "normal", "the object's normal"},
     {raster::MappingRay::reflection, "reflection", "the reflected ray"}});

template <>
inline constexpr auto kNames<raster::TileChange> =
    std::to_array<Named<raster::TileChange>>({{raster::TileChange::none, "none", "all the same"},
                                              {raster::TileChange::rotate, "rotate", "turned"},
                                              {raster::TileChange::shift, "shift", "moved"},
                                              {raster::TileChange::both, "both", "turned and moved"}});

template <>
inline constexpr auto kNames<raster::TextureEnvMode> =
    std::to_array<Named<raster::TextureEnvMode>>({{raster::TextureEnvMode::modulate, "modulate"},
                                                  {raster::TextureEnvMode::replace, "replace"},
                                                  {raster::TextureEnvMode::add, "add"},
                                                  {raster::TextureEnvMode::decal, "decal"},
                                                  {raster::TextureEnvMode::blend, "blend"},
                                                  {raster::TextureEnvMode::combine, "combine"}});

template <>
inline constexpr auto kNames<raster::CombineFunction> =
    std::to_array<Named<raster::CombineFunction>>({{raster::CombineFunction::replace, "replace"},
                                                   {raster::CombineFunction::modulate, "modulate"},
                                                   {raster::CombineFunction::add, "add"},
                                                   {raster::CombineFunction::add_signed, "add-signed"},
                                                   {raster::CombineFunction::interpolate, "interpolate"},
                                                   {raster::CombineFunction::subtract, "subtract"},
                                                   {raster::CombineFunction::dot3_rgb, "dot3-rgb"},
                                                   {raster::CombineFunction::dot3_rgba, "dot3-rgba"}});

template <>
inline constexpr auto kNames<raster::TextureRole> =
    std::to_array<Named<raster::TextureRole>>({{raster::TextureRole::environment, "environment"},
                                               {raster::TextureRole::normal, "normal", "normal map"},
                                               {raster::TextureRole::bump, "bump", "bump map"},
                                               {raster::TextureRole::occlusion, "occlusion", "occlusion map"},
                                               {raster::TextureRole::shine, "shine", "specularity map"}});

template <>
inline constexpr auto kNames<raster::BumpForm> = std::to_array<Named<raster::BumpForm>>(
    {{raster::BumpForm::invariant, "invariant"}, {raster::BumpForm::blinn, "blinn"}});

template <>
inline constexpr auto kNames<raster::CombineSource> =
    std::to_array<Named<raster::CombineSource>>({{raster::CombineSource::texture, "texture"},
                                                 {raster::CombineSource::constant, "constant"},
                                                 {raster::CombineSource::primary, "primary"},
                                                 {raster::CombineSource::previous, "previous"}});

template <>
inline constexpr auto kNames<raster::CombineOperand> = std::to_array<Named<raster::CombineOperand>>(
    {{raster::CombineOperand::color, "color"},
     {raster::CombineOperand::one_minus_color, "one-minus-color"},
     {raster::CombineOperand::alpha, "alpha"},
     {raster::CombineOperand::one_minus_alpha, "one-minus-alpha"}});

template <>
inline constexpr auto kNames<raster::FogMode> = std::to_array<Named<raster::FogMode>>(
    {{raster::FogMode::linear, "linear"}, {raster::FogMode::exp, "exp"}, {raster::FogMode::exp2, "exp2"}});

template <>
inline constexpr auto kNames<raster::BlendFactor> = std::to_array<Named<raster::BlendFactor>>(
    {{raster::BlendFactor::zero, "zero"},
     {raster::BlendFactor::one, "one"},
     {raster::BlendFactor::src_color, "src-color"},
     {raster::BlendFactor::one_minus_src_color, "one-minus-src-color"},
     {raster::BlendFactor::dst_color, "dst-color"},
     {raster::BlendFactor::one_minus_dst_color, "one-minus-dst-color"},
     {raster::BlendFactor::src_alpha, "src-alpha"},
     {raster::BlendFactor::one_minus_src_alpha, "one-minus-src-alpha"},
     {raster::BlendFactor::dst_alpha, "dst-alpha"},
     {raster::BlendFactor::one_minus_dst_alpha, "one-minus-dst-alpha"},
     {raster::BlendFactor::constant_color, "constant-color"},
     {raster::BlendFactor::one_minus_constant_color, "one-minus-constant-color"},
     {raster::BlendFactor::constant_alpha, "constant-alpha"},
     {raster::BlendFactor::one_minus_constant_alpha, "one-minus-constant-alpha"},
     {raster::BlendFactor::src_alpha_saturate, "src-alpha-saturate"}});

template <>
inline constexpr auto kNames<raster::BlendEquation> = std::to_array<Named<raster::BlendEquation>>(
    {{raster::BlendEquation::add, "add"},
     {raster::BlendEquation::subtract, "subtract"},
     {raster::BlendEquation::reverse_subtract, "reverse-subtract"},
     {raster::BlendEquation::min, "min"},
     {raster::BlendEquation::max, "max"}});

template <>
inline constexpr auto kNames<raster::ToneMap> = std::to_array<Named<raster::ToneMap>>(
    {{raster::ToneMap::clamp, "clamp"}, {raster::ToneMap::reinhard, "reinhard", "Reinhard"}});

template <>
inline constexpr auto kNames<raster::PixelFilterKind> =
    std::to_array<Named<raster::PixelFilterKind>>({{raster::PixelFilterKind::box, "box"},
                                                   {raster::PixelFilterKind::triangle, "triangle"},
                                                   {raster::PixelFilterKind::cone, "cone"},
                                                   {raster::PixelFilterKind::gaussian, "gaussian"},
                                                   {raster::PixelFilterKind::mitchell, "mitchell"}});

template <>
inline constexpr auto kNames<raster::FilterOrder> = std::to_array<Named<raster::FilterOrder>>(
    {{raster::FilterOrder::light, "light"}, {raster::FilterOrder::display, "display", "what is shown"}});

/// As stories write them, between two numbers.
template <>
inline constexpr auto kNames<raster::Compare> =
    std::to_array<Named<raster::Compare>>({{raster::Compare::never, "never"},
                                           {raster::Compare::less, "<"},
                                           {raster::Compare::equal, "="},
                                           {raster::Compare::less_equal, "<="},
                                           {raster::Compare::greater, ">"},
                                           {raster::Compare::not_equal, "!="},
                                           {raster::Compare::greater_equal, ">="},
                                           {raster::Compare::always, "always"}});

}  // namespace barrido

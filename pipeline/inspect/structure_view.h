// Views of what a frame costs and what it is made of, as false colour: how often each pixel is drawn, how
// many texels it reads, which triangle, mip level, texture coordinates, depth and normal it shows, and where
// shading leaves Mach bands. Enters: a scene and the settings of a frame; leaves: a number a pixel, and its
// colour.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "pipeline/inspect/view_colors.h"
#include "pipeline/scene/render_scene.h"
#include "raster/base/enum_names.h"

namespace barrido::inspect {

enum class StructureView : std::uint8_t {
  overdraw,       ///< Fragments shaded a pixel, in drawing order without visibility first.
  layers,         ///< Fragments that cover a pixel, hidden ones included.
  illuminations,  ///< Evaluations of one light a pixel; those of vertices and centroids where they lie.
  texels,         ///< Texels that filters read a pixel, in drawing order without visibility first.
  mip_level,      ///< Mip level that the visible surface's picture is read at.
  mip_colors,     ///< The frame with a colour for each mip level in place of the pictures.
  texel_density,  ///< Texels of its picture to a pixel, as a power of two.
  coordinates,    ///< (s, t) at which the visible surface's texture is looked up.
  triangles,      ///< A colour for each visible triangle.
  depth,          ///< Distance of the visible surface from the eye, along the line of sight.
  normals,        ///< Normal with which the visible surface is lit, in eye space.
  mach_bands,     ///< Second derivative of the frame's brightness: light bands and dark bands.
  samples,        ///< Samples a pixel takes.
  slivers,        ///< 1 where the corners of a pixel alone lose something (adaptive sampling), else 0.
};
}  // namespace barrido::inspect

namespace barrido {

template <>
inline constexpr auto kNames<inspect::StructureView> =
    std::to_array<Named<inspect::StructureView>>({{inspect::StructureView::overdraw, "overdraw"},
                                                  {inspect::StructureView::layers, "layers"},
                                                  {inspect::StructureView::illuminations, "illuminations"},
                                                  {inspect::StructureView::texels, "texels"},
                                                  {inspect::StructureView::mip_level, "mip-level"},
                                                  {inspect::StructureView::mip_colors, "mip-colors"},
                                                  {inspect::StructureView::texel_density, "texel-density"},
                                                  {inspect::StructureView::coordinates, "coordinates"},
                                                  {inspect::StructureView::triangles, "triangles"},
                                                  {inspect::StructureView::depth, "depth"},
                                                  {inspect::StructureView::normals, "normals"},
                                                  {inspect::StructureView::mach_bands, "mach-bands"},
                                                  {inspect::StructureView::samples, "samples"},
                                                  {inspect::StructureView::slivers, "slivers"}});

}  // namespace barrido

namespace barrido::inspect {

inline constexpr int kStructureViewCount = static_cast<int>(kNames<StructureView>.size());

/// One sentence a view, for help and panels.
std::string_view description_of(StructureView view);

/// What a view found, before it is coloured. Arrays are in the frame's order, top row first.
struct ViewValues {
  StructureView view = StructureView::overdraw;
  int width = 0, height = 0;
  /// A pixel's number; NaN where there is none (background, or no picture). Of normals: x; of triangles: a
  /// number of the triangle.
  std::vector<float> values;
  std::vector<std::array<float, 3>> normals;  ///< Of StructureView::normals only; NaN for none.
  /// Of mip_colors: the frame as drawn. Of coordinates: red is s, green is t, within their tile.
  std::vector<std::uint32_t> colors;
  double least = 0.0, most = 0.0;  ///< Of the pixels that have a number; 0 where none has.
  double mean = 0.0;               ///< Of the pixels that have a number.
  std::uint64_t counted = 0;       ///< Pixels that have a number.
  std::uint64_t total = 0;         ///< Sum of counts over the picture; of triangles: how many are seen.
  /// Illuminations of vertices and centroids that lie outside the picture; in the frame's total, not in
  /// `total`.
  std::uint64_t outside = 0;
};

/// Works a view out. Other settings than those of the view (visibility_first, say) are as given.
/// @throws scene::InputError as SceneRenderer::render.
ViewValues measure_view(scene::SceneRenderer& renderer, const scene::RenderSettings& settings,
                        StructureView view);

/// The colour of a value of the view, as in its picture. Not for mip_colors, coordinates and normals, which
/// have colours of their own.
Rgb8 color_of(const ViewValues& values, float value);

/// The values in false colour: packed, opaque, a pixel each.
std::vector<std::uint32_t> colors_of(const ViewValues& values);

}  // namespace barrido::inspect

// The kernel key: everything about a draw that chooses between loops, compiled once from the fragment state
// as a chunk is binned. Kernels ask the key which loop is to run, and the state only with which numbers.
// kKernelKeyFacts says of each thing that could choose a loop whether it does, and why. Knows no loop.
#pragma once

#include <string_view>

#include "raster/fragments/primitive.h"
#include "raster/tiles/framebuffer.h"

namespace barrido::raster {

/// Where the colours of fragments are made.
enum class ColorWay : std::uint8_t {
  batch,   ///< In the batch's arrays, stage by stage (shade_batch.cpp).
  flat,    ///< One colour a primitive, straight to the 8-bit surface.
  smooth,  ///< From four planes straight to the 8-bit surface.
};

/// What a fragment's colour does with the one that stands in its pixel.
enum class Blending : std::uint8_t {
  replace,       ///< It is not read.
  constant,      ///< Factors that are the same for all fragments, added: kept in registers.
  source_alpha,  ///< The usual transparency: source alpha, one minus source alpha.
  general,       ///< Any factors and equation.
};

/// `less` and `less_equal` write the depth at once; `any` is every other test.
enum class DepthTest : std::uint8_t { off, less, less_equal, any };

/// What becomes of small triangles; those that are too large for a way take the one before it.
enum class SmallTriangles : std::uint8_t {
  spans,   ///< As all others.
  blocks,  ///< Several rows at once (blocks-inl.h).
  lists,   ///< The tiniest, many at once (tiny_triangles-inl.h).
};

struct KernelKey {
  ColorFormat surface = ColorFormat::rgba8;
  ColorWay colors = ColorWay::batch;
  Blending blending = Blending::replace;
  bool sorted = false;
  DepthTest depth = DepthTest::off;
  bool late_depth = false;
  bool hides = false;
  SmallTriangles small = SmallTriangles::spans;
  bool divides_color = false;
  bool takes_primary = true;
  bool fills_primary = false;
  bool fills_secondary = false;
  bool unit_colors = false;
  std::uint8_t lod_units = 0;  ///< Bit u: texture unit u.

  friend bool operator==(const KernelKey&, const KernelKey&) = default;
};

struct KernelKeyFact {
  std::string_view name;
  bool in_key;
  std::string_view why;
};

/// The fields of the key in their order, then what is not in it. In the key is what changes the arrays that a
/// loop touches or what it keeps in registers.
inline constexpr KernelKeyFact kKernelKeyFacts[] = {
    {"surface", true, "bytes or four planes of floats are read and written"},
    {"colors", true, "the batch's arrays, one packed number or four planes are in hand"},
    {"blending", true, "what stands in the pixel is read or not, and factors stay in registers or not"},
    {"sorted", true, "fragments wait in lists with their depths in place of being blended"},
    {"depth", true, "no depth is touched, one comparison decides, or the masks of all eight do"},
    {"late_depth", true, "the alpha test decides, so the batch carries depths to its end"},
    {"hides", true, "opaque: a look at visibility first costs marks and saves shading"},
    {"small", true, "spans, blocks and lists are three walks over the same pixels"},
    {"divides_color", true, "smooth colours stand divided by w: q is interpolated as well"},
    {"takes_primary", true, "a first texture that replaces the primary colour leaves its arrays alone"},
    {"fills_primary", true, "the colour is the primitive's: arrays are filled, not interpolated"},
    {"fills_secondary", true, "the same of the secondary colour"},
    {"unit_colors", true, "colours that come to their end clamped are rounded without clamping"},
    {"lod_units", true, "groups of four pixels are kept for units whose filters ask for them"},

    {"topology", false, "finds spans, before any of these loops; it is the chunk's"},
    {"scissor", false, "cuts spans to columns; numbers, and each tile asks whether it is cut at all"},
    {"polygon_offset", false, "moves planes before the first pixel; lists have no room for it: see small"},
    {"comparison", false,
     "of depth and alpha: beside less a value, since one loop with masks does all eight"},
    {"q", false, "whether it is 1 everywhere is known triangle by triangle"},
    {"range", false, "whether depths and colours need clamping is known at the ends of a span"},
    {"factors", false, "of blending: numbers, unless they stay in registers: see blending"},
    {"color_mask", false, "one mask of bits for all pixels; no mask is part of being opaque: see hides"},
    {"stages", false, "each works on whole batches: no loop has one inside; which there are leads to colors"},
    {"texture_units", false, "texel formats, filters and environments choose inside a unit's own step"},
    {"exposure, tone map", false, "meet finished tiles: resolve.h"},
};

/// Floats of the records that the lists of tiny triangles have room for: depth, q, a colour, and what fills a
/// group of eight.
inline constexpr int kTinyQuantities = 8;

/// The key of a draw into a frame of this format. `by_batches`: never straight to the surface.
KernelKey make_kernel_key(const FragmentState& state, ColorFormat surface, bool by_batches = false);

/// Whether the unit's filters depend on the level of detail.
inline bool needs_lod(const TextureUnit& unit) {
  return has_wide_filter(unit) ||
         !((unit.min_filter == MinFilter::nearest && unit.mag_filter == MagFilter::nearest) ||
           (unit.min_filter == MinFilter::linear && unit.mag_filter == MagFilter::linear));
}

}  // namespace barrido::raster
